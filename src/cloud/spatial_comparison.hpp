// What changed between two sides, whether the camera came back or not.
#pragma once

#include <vector>

#include "cloud/depth_view.hpp"
#include "cloud/fused_change.hpp"
#include "cloud/registration.hpp"
#include "detect/calibrated/calibrated.hpp"

namespace rva {

/// A change, and how the tails of what unchanged places show in such a one usually fall off.
struct SpatialChange {
  DisparityChange change;
  UsualSlopes slopes;
  double disparity_m_px = 0.0;  ///< focal length times baseline of the final camera
};

/// The usual slopes where two views were registered, and where one capture a side is a degree or two off, as
/// `script/fit` measures them (docs/statistics.md). Depth that went missing is no evidence there, so those of
/// losses are never used.
inline constexpr UsualSlopes slopes_of_moved_cameras{{{1.07, 35.36}, {0.61, 8.41}}, slopes_of_means.loss};
inline constexpr UsualSlopes slopes_of_bumped_cameras{{{1.23, 17.93}, {0.64, 7.87}}, slopes_of_means.loss};

/// What is known of the camera's motion before the images are registered.
enum class KnownMotion {
  moved,   ///< the robot was moved, or several captures a side were taken
  bumped,  ///< the camera was meant to stand still: one capture a side, from nearly one place
};

/// By free space, between views that lie over each other.
/// @param registration to be trusted
[[nodiscard]] SpatialChange change_from_elsewhere(const DepthView& initial, const DepthView& final,
                                                  const Registration& registration,
                                                  KnownMotion known = KnownMotion::moved);

/// Pixel by pixel, between captures of which each final one has an initial one of the same pose.
/// @param changes        at least one, all of `camera`; the result is in the first one's view
/// @param disparity_m_px focal length times baseline
[[nodiscard]] SpatialChange change_from_same_places(std::vector<PlacedChange> changes,
                                                    const Intrinsics& camera, double disparity_m_px);

/// Judged as the calibrated detector judges change.
/// @param unit_m metres of one step of the depth images
[[nodiscard]] CalibratedComparison compare_spatial(const SpatialChange& change, double unit_m,
                                                   const CalibratedOptions& options);

}  // namespace rva
