// Implements a custom detector: it marks changed pixels from the statistics of two captures, and leaves
// regions, positions and scores to the library. Run it as `build/examples/own_detector INITIAL FINAL`.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "capture/capture.hpp"
#include "core/error.hpp"
#include "detect/findings/detection.hpp"
#include "detect/findings/findings.hpp"

namespace {

// A pixel changed if its mean disparity differs by four standard deviations of a single frame or more. The
// 0.2 px represent errors that are the same in every frame.
rva::Comparison compare(const rva::Capture& initial_capture, const rva::Capture& final_capture) {
  const rva::CaptureInfo& info = final_capture.info();
  if (initial_capture.info().depth != info.depth || initial_capture.info().depth_unit_m != info.depth_unit_m)
    throw rva::Error("captures", "differ in intrinsics or depth unit", "give two captures of one camera");
  rva::Runtime runtime;
  const auto initial = rva::statistics_of(initial_capture, initial_capture.depth_frames(), {}, runtime);
  const auto final = rva::statistics_of(final_capture, final_capture.depth_frames(), {}, runtime);
  const double disparity_px = rva::stereo_scale(info).focal_baseline_units_px();
  rva::Comparison comparison(final.width(), final.height());
  for (std::size_t i = 0; i < final.size(); ++i) {
    if (!initial.seen(i) || !final.seen(i)) continue;
    comparison.coverage.compared += 1.0 / static_cast<double>(final.size());
    const double before = initial.mean(i);
    const double after = final.mean(i);
    comparison.initial_m[i] = static_cast<float>(before * info.depth_unit_m);
    comparison.final_m[i] = static_cast<float>(after * info.depth_unit_m);
    const double change_px = disparity_px / after - disparity_px / before;
    const double noise_px = std::hypot(disparity_px / (before * before) * initial.standard_deviation(i),
                                       disparity_px / (after * after) * final.standard_deviation(i), 0.2);
    if (std::abs(change_px) < 4.0 * noise_px) continue;
    comparison.changed[i] = rva::mask_set;
    comparison.farther[i] = change_px < 0.0 ? rva::mask_set : 0;
    comparison.evidence[i] = static_cast<float>(std::abs(change_px) / noise_px);
  }
  return comparison;
}

void detect(const rva::Capture& initial, const rva::Capture& final) {
  const rva::Comparison comparison = compare(initial, final);
  for (const auto& finding : rva::find_findings(comparison, {.min_blob_px = 40}, final.info().depth)) {
    // Every changed pixel has a depth, so every finding has a position and a score.
    const Eigen::Vector3d at_m = finding.position_m.value_or(Eigen::Vector3d::Zero());
    fmt::print("{:3} {:8}  at ({:.3f}, {:.3f}, {:.3f}) m  {:5} px  score {:.1f}\n", finding.id,
               rva::name_of(finding.kind), at_m.x(), at_m.y(), at_m.z(), finding.pixels.size(),
               finding.score.value_or(0.0));
  }
  fmt::print("compared {:.1f} % of the pixels\n", 100.0 * comparison.coverage.compared);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: own_detector INITIAL FINAL\n");
    return 2;
  }
  try {
    detect(*rva::open_capture(argv[1]), *rva::open_capture(argv[2]));
    return 0;
  } catch (const rva::Error& error) {
    fmt::print(stderr, "own_detector: {}\n", error.what());
    return 1;
  }
}
