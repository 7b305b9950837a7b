// Opens a capture of any format that the library reads and prints its intrinsics, its frames, its depth unit
// and the nearest and the farthest depth. Run it as `build/examples/open_capture data/bin-tools/final`.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "capture/capture.hpp"
#include "capture/frame_reader.hpp"
#include "core/error.hpp"

namespace {

void describe(const rva::Capture& capture) {
  const rva::CaptureInfo& info = capture.info();
  const rva::Intrinsics& camera = info.depth;
  fmt::print("format      {}\n", info.format);
  fmt::print("intrinsics  {}x{}, fx {:.3f} fy {:.3f} cx {:.3f} cy {:.3f}\n", camera.width, camera.height,
             camera.fx, camera.fy, camera.cx, camera.cy);
  fmt::print("frames      {} depth, {} color\n", capture.depth_frames(), capture.color_frames());
  fmt::print("depth unit  {} m{}\n", info.depth_unit_m, info.unit_is_assumed ? " (assumed)" : "");

  std::uint16_t nearest = std::numeric_limits<std::uint16_t>::max();
  std::uint16_t farthest = rva::no_depth;
  const auto include = [&](const rva::DepthImage& frame) {
    for (const std::uint16_t depth : frame.pixels()) {
      if (depth == rva::no_depth) continue;
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
  };
  rva::for_each_depth_frame(capture, capture.depth_frames(), {}, include);
  if (farthest == rva::no_depth) {
    fmt::print("depth       not measured in any pixel\n");
  } else {
    fmt::print("depth       {:.4f} to {:.4f} m\n", nearest * info.depth_unit_m, farthest * info.depth_unit_m);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: open_capture CAPTURE\n");
    return 2;
  }
  try {
    describe(*rva::open_capture(argv[1]));
    return 0;
  } catch (const rva::Error& error) {
    fmt::print(stderr, "open_capture: {}\n", error.what());
    return 1;
  }
}
