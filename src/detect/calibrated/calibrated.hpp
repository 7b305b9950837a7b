// The `calibrated` method: detects changes against a noise model that is learnt from the two captures.
#pragma once

#include <vector>

#include "core/options.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/calibrated/false_alarm_tail.hpp"
#include "detect/calibrated/level_of_detection.hpp"
#include "detect/calibrated/unreliable_pixels.hpp"
#include "detect/regions/comparison.hpp"
#include "geometry/stereo_scale.hpp"
#include "views/disparity_change.hpp"

namespace rva {

/// Options of the method `calibrated`.
struct CalibratedOptions {
  double false_findings = 0.05;

  static void describe(auto&& self, auto&& visit) {
    visit(self.false_findings,
          OptionField{
              "false-findings", "", 1e-9, 1000,
              "calibrated, spatial: findings that an inspection may show on average where nothing changed"});
  }
};

/// The result of the method `calibrated`: changed pixels with their evidence, and the level of detection.
struct CalibratedComparison {
  Comparison comparison;               ///< evidence is -log10 of the expected false findings as strong
  Image<float> level_of_detection_mm;  ///< NaN where not judged
  DetectionLevelSummary levels;
};

/// Prior slopes of the tails of evidence in unchanged images, for pixels where depth changed and where it was
/// lost. An image with too few peaks to learn a slope from is assumed to have the prior one.
struct PriorSlopes {
  ByReliability<PriorSlope> change;
  ByReliability<PriorSlope> loss;
};

/// Prior slopes of means over several frames, as measured by `script/fit`, and of single frames, within the
/// confidence intervals of those measurements (docs/statistics.md). With a single frame, wrong matches cannot
/// be distinguished from noise, so all pixels have the same slope.
inline constexpr PriorSlopes slopes_of_means{{{1.30, 9.70}, {1.25, 6.70}}, {{0.88, 4.84}, {0.76, 6.30}}};
inline constexpr PriorSlopes slopes_of_single_frames{{{1.05, 7.00}, {1.05, 7.00}},
                                                     {{0.38, 10.36}, {0.38, 10.36}}};

/// Prior slopes for a camera that did not move.
/// @param frames number of frames of the side that has fewer
[[nodiscard]] PriorSlopes prior_slopes(std::size_t frames);

/// Heights of the peaks of pooled evidence, for all window sizes together.
struct CalibratedPeaks {
  ByReliability<std::vector<float>> change;
  ByReliability<std::vector<float>> loss;
};

/// Returns the peaks from which the tails of a comparison are learnt.
[[nodiscard]] CalibratedPeaks peaks_of(const DisparityChange& change, const StereoScale& stereo);

/// Compares means in disparity (docs/calibrated.md): subtracts the drift, divides by the noise of each pixel,
/// pools windows of 7, 15 and 31 pixels, and marks nearer and farther pixels above the threshold that
/// `false_findings` locations of an unchanged inspection exceed on average.
/// @param initial, final statistics before and after, of one size and depth unit
/// @param stereo any focal length times baseline if it is not known: only drift_px and fixed_px depend on it
[[nodiscard]] CalibratedComparison compare_calibrated(const DepthStatistics& initial,
                                                      const DepthStatistics& final, const StereoScale& stereo,
                                                      const CalibratedOptions& options);

/// Compares as above, given the change in disparity.
/// @param slopes prior slopes of changes of this kind
[[nodiscard]] CalibratedComparison compare_calibrated(const DisparityChange& change,
                                                      const StereoScale& stereo, const PriorSlopes& slopes,
                                                      const CalibratedOptions& options);

}  // namespace rva
