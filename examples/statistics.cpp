// Computes the mean and the standard deviation of every pixel over the frames of a capture of a still scene,
// and prints the median noise in millimetres and in disparity. Run it as `build/examples/statistics CAPTURE`,
// where CAPTURE has two frames or more, e.g. one that the example `simulate` wrote.
#include <fmt/format.h>

#include <cstddef>
#include <vector>

#include "capture/capture.hpp"
#include "capture/frame_reader.hpp"
#include "core/error.hpp"
#include "core/quantile.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/findings/detection.hpp"
#include "geometry/stereo_scale.hpp"

namespace {

void print_noise(const rva::Capture& capture) {
  const rva::CaptureInfo& info = capture.info();
  rva::DepthStatistics statistics(info.depth.width, info.depth.height);
  rva::for_each_depth_frame(capture, capture.depth_frames(), {},
                            [&](const rva::DepthImage& frame) { statistics.add(frame); });

  // Disparity is d = f b / z, so a deviation of z is one of f b / z^2 times as much in disparity. There the
  // noise of a stereo camera hardly depends on distance.
  const rva::StereoScale stereo = rva::stereo_scale(info);
  std::vector<double> means_m;
  std::vector<double> noise_mm;
  std::vector<double> noise_px;
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    if (statistics.count(i) < 2) continue;
    const double mean_m = statistics.mean(i) * info.depth_unit_m;
    const double deviation_m = statistics.standard_deviation(i) * info.depth_unit_m;
    means_m.push_back(mean_m);
    noise_mm.push_back(1000.0 * deviation_m);
    noise_px.push_back(deviation_m * stereo.disparity_px(mean_m) / mean_m);
  }
  if (means_m.empty())
    throw rva::Error("capture", "no pixel was measured in two frames", "give a capture of several frames");
  fmt::print("{} frames, {} of {} pixels measured at least twice\n", statistics.frames(), means_m.size(),
             statistics.size());
  fmt::print("median depth {:.3f} m, median noise {:.3f} mm, {:.4f} px of disparity\n",
             rva::quantile(means_m, 0.5), rva::quantile(noise_mm, 0.5), rva::quantile(noise_px, 0.5));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: statistics CAPTURE\n");
    return 2;
  }
  try {
    print_noise(*rva::open_capture(argv[1]));
    return 0;
  } catch (const rva::Error& error) {
    fmt::print(stderr, "statistics: {}\n", error.what());
    return 1;
  }
}
