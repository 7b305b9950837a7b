// Compares two sides, whether the camera returned exactly or not.
#pragma once

#include <vector>

#include "detect/calibrated/calibrated.hpp"
#include "geometry/stereo_scale.hpp"
#include "views/depth_view.hpp"
#include "views/fused_change.hpp"
#include "views/registration.hpp"

namespace rva {

/// A change, and the prior slopes of the tails of evidence where nothing changed in such a comparison.
struct SpatialChange {
  DisparityChange change;
  PriorSlopes slopes;
  StereoScale stereo;  ///< of the final camera
};

/// Prior slopes of registered views, and of single captures that are a degree or two off, as measured
/// by `script/fit` (docs/statistics.md). Lost depth is no evidence there, so the slopes of losses are
/// never used.
inline constexpr PriorSlopes slopes_of_moved_cameras{{{1.07, 35.36}, {0.61, 8.41}}, slopes_of_means.loss};
inline constexpr PriorSlopes slopes_of_bumped_cameras{{{1.23, 17.93}, {0.64, 7.87}}, slopes_of_means.loss};

/// What is known of the camera's motion before the images are registered.
enum class KnownMotion {
  moved,   ///< the robot was moved, or several captures a side were taken
  bumped,  ///< the camera was meant to stand still: one capture a side, from nearly one pose
};

/// Compares registered views by free space.
/// @param registration must be reliable
[[nodiscard]] SpatialChange change_from_elsewhere(const DepthView& initial, const DepthView& final,
                                                  const Registration& registration,
                                                  KnownMotion known = KnownMotion::moved);

/// Compares captures pixel by pixel, where each final one has an initial one of the same pose.
/// @param changes        at least one, all of `camera`; the result is in the view of the first one
[[nodiscard]] SpatialChange change_from_same_places(std::vector<PlacedChange> changes,
                                                    const Intrinsics& camera, const StereoScale& stereo);

/// Judges a change as the `calibrated` method does.
[[nodiscard]] CalibratedComparison compare_spatial(const SpatialChange& change,
                                                   const CalibratedOptions& options);

}  // namespace rva
