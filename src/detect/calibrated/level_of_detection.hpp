// What an inspection could have found, and where it could not have found anything.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "depth/image.hpp"
#include "detect/calibrated/scale.hpp"

namespace rva {

/// Evidence of a single pixel counts up to so many deviations: one wild pixel is no change.
inline constexpr double most_deviations = 20.0;

/// What is so many deviations above a threshold is found in nine of ten inspections: normal distribution.
inline constexpr double nine_of_ten_deviations = 1.2816;

/// The finest scale whose threshold a change of any height can reach where the matcher is sure; else the
/// last.
[[nodiscard]] const Scale& finest_reachable(std::span<const Scale> scales);

/// The least height of a thing that would have been found at a pixel in nine of ten inspections like this
/// one, millimetres along z; NaN where nothing could be judged. The thing shows in the depth image as wide as
/// the scale's window: a matcher with windows of its own shows nothing much smaller, and some things smaller
/// than that not at all (docs/calibrated.md).
/// @param unsure         as of unsure_places()
/// @param deviation_px   of an unchanged pixel's disparity; 0 where not judged
/// @param depth_m        0 where not measured
/// @param disparity_m_px focal length times baseline: disparity in pixels times depth in metres
[[nodiscard]] Image<float> level_of_detection_mm(const Mask& unsure, const Image<float>& deviation_px,
                                                 const Image<float>& depth_m, const Scale& scale,
                                                 double disparity_m_px);

struct DetectionLevels {
  double from_m = 0.0;
  double to_m = 0.0;
  std::size_t pixels = 0;  ///< judged, to three
  double median_mm = 0.0;
  double p90_mm = 0.0;  ///< nine tenths of the pixels are as good or better
};

struct DetectionLevelSummary {
  double judged = 0.0;    ///< share of the depth image
  int window_px = 0;      ///< width in the image of the things that the levels are about
  double drift_px = 0.0;  ///< what was taken from all disparities, in the middle of the image
  double fixed_px = 0.0;  ///< noise of a pixel that no number of frames averages away
  std::optional<double> effective_frames;
  std::vector<DetectionLevels> by_distance;  ///< near to far, of 0.2 m each, those that hold pixels
};

/// Share of the image that has a level.
[[nodiscard]] double judged_share(const Image<float>& level_mm);

[[nodiscard]] std::vector<DetectionLevels> levels_by_distance(const Image<float>& level_mm,
                                                              const Image<float>& depth_m);

/// `level_of_detection.json` (docs/calibrated.md), ending in a line feed.
[[nodiscard]] std::string to_json(const DetectionLevelSummary& summary);

/// Blue where small things would have been found, red where only large ones; black where nothing could be
/// judged; with a bar of the colours.
[[nodiscard]] ColorImage draw_level_of_detection(const Image<float>& level_mm);

}  // namespace rva
