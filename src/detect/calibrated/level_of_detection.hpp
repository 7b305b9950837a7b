// Level of detection: the least height that an inspection could have found at each pixel.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

#include "depth/image.hpp"
#include "detect/calibrated/scale.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva {

/// Evidence of a single pixel is limited to this many deviations, so that one outlier is not taken for
/// a change.
inline constexpr double most_deviations = 20.0;

/// A change whose expected evidence lies this many deviations above a threshold is found in nine of ten
/// inspections, for a normal distribution.
inline constexpr double nine_of_ten_deviations = 1.2816;

/// Returns the finest scale whose threshold a change can reach at reliable pixels, given the limit of
/// most_deviations per pixel; the last scale if there is none.
[[nodiscard]] const Scale& finest_reachable(std::span<const Scale> scales);

/// Computes the least height of an object that would have been found at a pixel in nine of ten inspections
/// like this one, millimetres along z; NaN where nothing could be judged. The object is assumed to appear in
/// the depth image as wide as the window of the scale. A matcher with windows of its own shows hardly
/// anything smaller than its window, and some smaller objects not at all (docs/calibrated.md).
/// @param unreliable   as returned by unreliable_pixels()
/// @param deviation_px   standard deviation of the disparity change of an unchanged pixel; 0 where not judged
/// @param depth_m      depth after, metres; 0 where not measured
[[nodiscard]] Image<float> level_of_detection_mm(const Mask& unreliable, const Image<float>& deviation_px,
                                                 const Image<float>& depth_m, const Scale& scale,
                                                 const StereoScale& stereo);

/// Levels of detection of the pixels whose depth is from `from_m` to `to_m`.
struct DetectionLevels {
  double from_m = 0.0;
  double to_m = 0.0;
  std::size_t pixels = 0;  ///< number of judged pixels among every third pixel of the image
  double median_mm = 0.0;
  double p90_mm = 0.0;  ///< 90th percentile: nine tenths of the pixels are as good or better
  /// What is window_px wide in the image is as wide as this at to_m; empty where it was not asked for.
  std::optional<double> width_mm{};
};

/// Where objects of one size would have been found.
struct FindableShare {
  double size_mm = 0.0;  ///< height along z and width
  double share = 0.0;    ///< of the depth image, 0 to 1
};

/// Levels of detection of an image, summarised for the user.
struct DetectionLevelSummary {
  double judged = 0.0;    ///< share of the depth image
  int window_px = 0;      ///< width in the image of the objects to which the levels apply
  double drift_px = 0.0;  ///< drift subtracted from the disparities, in the middle of the image
  double fixed_px = 0.0;  ///< noise of a pixel that does not decrease with the number of frames
  /// Number of independent frames, see NoiseByClass; empty if it could not be estimated.
  std::optional<double> effective_frames;
  std::vector<DetectionLevels> by_distance;  ///< classes of 0.2 m that contain pixels, near to far
  std::vector<FindableShare> findable{};     ///< small to large; empty where it was not asked for
};

/// Share of the pixels that have a level of detection.
[[nodiscard]] double judged_share(const Image<float>& level_mm);

/// Summarises levels by distance, in classes of 0.2 m.
[[nodiscard]] std::vector<DetectionLevels> levels_by_distance(const Image<float>& level_mm,
                                                              const Image<float>& depth_m);

/// Sets `width_mm` of all distances.
/// @param focal_px focal length of the depth image
void state_widths(DetectionLevelSummary& summary, double focal_px);

/// Sizes of objects for which it is stated where they would have been found, millimetres.
inline constexpr std::array findable_sizes_mm{5.0, 10.0, 20.0};

/// The pixels at which an object as high and as wide as `size_mm` would have been found: where the level is
/// that height or less, and where the object appears as wide as the window at that depth, as the level
/// requires. None where not judged.
/// @param depth_m  depth after, metres; 0 where not measured
/// @param focal_px focal length of the depth image
[[nodiscard]] Mask findable_mask(const Image<float>& level_mm, const Image<float>& depth_m, int window_px,
                                 double focal_px, double size_mm);

/// The share of the depth image that findable_mask() contains. It grows with the size and is at most
/// judged_share().
[[nodiscard]] double findable_share(const Image<float>& level_mm, const Image<float>& depth_m, int window_px,
                                    double focal_px, double size_mm);

/// findable_share() of objects of findable_sizes_mm.
[[nodiscard]] std::vector<FindableShare> findable_shares(const Image<float>& level_mm,
                                                         const Image<float>& depth_m, int window_px,
                                                         double focal_px);

/// The content of `level_of_detection.json` (docs/calibrated.md).
[[nodiscard]] nlohmann::ordered_json json_of(const DetectionLevelSummary& summary);

/// Draws levels with a colour bar: blue where small objects would have been found, red where only large ones,
/// black where nothing could be judged.
[[nodiscard]] ColorImage draw_level_of_detection(const Image<float>& level_mm);

}  // namespace rva
