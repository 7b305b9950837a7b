#include "detect/appearance/surface_level.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/units.hpp"

namespace rva {
namespace {

// Changes of a pixel or more are outside the range in which costs are parabolic about their minimum.
constexpr double most_px = 1.0;

}  // namespace

// Equation 30 of docs/math.md.
void lower_level_of_detection(const JudgedChange& light, double false_findings, const StereoScale& stereo,
                              Detection& detection) {
  const SurfaceChange& surface = light.surface;
  if (surface.judged.empty() || !detection.level_of_detection) return;
  Image<float>& least_mm = detection.level_of_detection->least_mm;
  const double needed = light.tail.height_of(0.5 * false_findings) + nine_of_ten_deviations;
  for (std::size_t i = 0; i < least_mm.size(); ++i) {
    const double depth_m = detection.final_m[i];
    if (surface.judged[i] == 0 || is_left_out(detection.left_out, i) || !(depth_m > 0.0)) continue;
    const double per_px = surface.deviations_per_px[i];
    if (needed >= most_px * per_px) continue;
    const auto own_mm =
        static_cast<float>(mm_per_m * depth_m * depth_m * needed / (per_px * stereo.focal_baseline_m_px));
    if (!(least_mm[i] <= own_mm)) least_mm[i] = own_mm;
  }
  DetectionLevelSummary& summary = detection.level_of_detection->summary;
  summary.window_px = std::max(summary.window_px, surface_window_px);
  summary.judged = judged_share(least_mm);
  summary.by_distance = levels_by_distance(least_mm, detection.final_m);
}

}  // namespace rva
