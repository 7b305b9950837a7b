// The method of this program's own: what changed, by a noise that is learnt from the two captures.
#pragma once

#include <vector>

#include "core/options.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/calibrated/disparity_change.hpp"
#include "detect/calibrated/false_alarm_tail.hpp"
#include "detect/calibrated/level_of_detection.hpp"
#include "detect/calibrated/unsure_places.hpp"
#include "detect/comparison.hpp"

namespace rva {

struct CalibratedOptions {
  double false_findings = 0.05;

  static void describe(auto&& self, auto&& visit) {
    visit(self.false_findings,
          OptionField{
              "false-findings", "", 1e-9, 1000,
              "calibrated, spatial: findings that an inspection may show on average where nothing changed"});
  }
};

struct CalibratedComparison {
  Comparison comparison;               ///< evidence is -log10 of the expected false findings as strong
  Image<float> level_of_detection_mm;  ///< NaN where not judged
  DetectionLevelSummary levels;
};

/// How the tails of what unchanged places show usually fall off: where an image has few peaks to learn from,
/// it is taken to be as others are.
struct UsualSlopes {
  ByPlace<UsualSlope> change;
  ByPlace<UsualSlope> loss;
};

/// The usual slopes of means over several frames, as `script/fit` measures them, and of single frames, within
/// the intervals of those (docs/statistics.md). A single frame cannot tell wrong matches from noise, so that
/// all of its places have the same slope.
inline constexpr UsualSlopes slopes_of_means{{{1.30, 9.70}, {1.25, 6.70}}, {{0.88, 4.84}, {0.76, 6.30}}};
inline constexpr UsualSlopes slopes_of_single_frames{{{1.05, 7.00}, {1.05, 7.00}},
                                                     {{0.38, 10.36}, {0.38, 10.36}}};

/// Of a camera that did not move.
/// @param frames of the side that has fewer
[[nodiscard]] UsualSlopes usual_slopes(std::size_t frames);

/// Heights of the peaks of pooled evidence, of all windows together.
struct CalibratedPeaks {
  ByPlace<std::vector<float>> change;
  ByPlace<std::vector<float>> loss;
};

/// What the tails of a comparison are learnt from.
/// @param disparity_by_depth as for disparity_change()
[[nodiscard]] CalibratedPeaks peaks_of(const DisparityChange& change, double disparity_by_depth);

/// Compares means in disparity: takes off the drift, divides by the noise of the place, pools windows of 7,
/// 15 and 31 pixels, and marks what is higher than `false_findings` places of an unchanged image would be,
/// both nearer and farther (docs/calibrated.md).
/// @param initial, final one size, one depth unit
/// @param unit_m         metres of one depth unit
/// @param disparity_m_px focal length times baseline; where that is not known, any: only drift_px and
/// fixed_px
///                       depend on it
[[nodiscard]] CalibratedComparison compare_calibrated(const DepthStatistics& initial,
                                                      const DepthStatistics& final, double unit_m,
                                                      double disparity_m_px,
                                                      const CalibratedOptions& options);

/// The same, of a change in disparity that is known already.
/// @param disparity_by_depth as for disparity_change()
/// @param slopes             of such changes
[[nodiscard]] CalibratedComparison compare_calibrated(const DisparityChange& change,
                                                      double disparity_by_depth, double disparity_m_px,
                                                      const UsualSlopes& slopes,
                                                      const CalibratedOptions& options);

}  // namespace rva
