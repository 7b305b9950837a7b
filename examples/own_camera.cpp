// Derives a camera from rva::Camera that makes frames of a tilted plane with noise, and records it into a
// capture folder. Run it as `build/examples/own_camera /tmp/tilted-plane`.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "camera/camera.hpp"
#include "camera/recording.hpp"
#include "capture/folder/capture_writer.hpp"
#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "core/random.hpp"
#include "geometry/stereo_scale.hpp"

namespace {

class TiltedPlane : public rva::Camera {
 public:
  [[nodiscard]] rva::CaptureInfo info() const override {
    rva::CaptureInfo info;
    info.depth = {.width = 320, .height = 240, .fx = 280.0, .fy = 280.0, .cx = 159.5, .cy = 119.5};
    info.depth_unit_m = 0.0001;
    info.camera = rva::CameraInfo{.model = "tilted plane", .serial = "", .baseline_m = 0.05};
    return info;
  }

  [[nodiscard]] std::optional<rva::CameraFrame> wait_for_frame() override {
    const rva::CaptureInfo view = info();
    const rva::StereoScale stereo = rva::stereo_scale(view);
    rva::CameraFrame frame;
    frame.number = number_++;
    frame.time_s = static_cast<double>(frame.number) / 30.0;
    frame.depth = rva::DepthImage(view.depth.width, view.depth.height);
    for (int v = 0; v < view.depth.height; ++v) {
      for (int u = 0; u < view.depth.width; ++u) {
        const double plane_m = 1.0 / (1.0 - 0.3 * (u - view.depth.cx) / view.depth.fx);  // z = 1 m + 0.3 x
        const double depth_m = stereo.depth_m(stereo.disparity_px(plane_m) + 0.1 * random_.normal());
        frame.depth(u, v) = static_cast<std::uint16_t>(std::lround(depth_m / view.depth_unit_m));
      }
    }
    return frame;
  }

 private:
  rva::Random random_{1};
  std::uint64_t number_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: own_camera OUT\n");
    return 2;
  }
  try {
    TiltedPlane camera;
    rva::OutputFolder folder(argv[1], rva::capture_files(), rva::Existing::refuse);
    rva::CaptureWriter writer(folder.path(""), camera.info());
    rva::record(camera, 20, writer, {});
    folder.commit();
    fmt::print("recorded 20 frames to {}\n", argv[1]);
    return 0;
  } catch (const rva::Error& error) {
    fmt::print(stderr, "own_camera: {}\n", error.what());
    return 1;
  }
}
