// Fuses changes observed from nearly one pose.
#pragma once

#include <vector>

#include "geometry/intrinsics.hpp"
#include "geometry/stereo_scale.hpp"
#include "geometry/transform.hpp"
#include "views/disparity_change.hpp"

namespace rva {

/// The change between two captures of one pose, and that pose.
struct PlacedChange {
  DisparityChange change;                             ///< between the captures of this pose
  Transform first_from_view = Transform::Identity();  ///< pose of the view in the frame of the first one
};

/// Fuses the changes of several views into the first one. In a single view that returned exactly, the errors
/// of the matcher cancel pixel by pixel, but so does a small object on which no dot falls. A few servo steps
/// away, other dots fall on it. Each pixel of the result is the mean of the changes that the views have on
/// that surface, each without its drift; at least half of the views must have one. Lost depth is that of the
/// first view.
/// @param changes at least one, all of `camera`
[[nodiscard]] DisparityChange fuse(std::vector<PlacedChange> changes, const Intrinsics& camera,
                                   const StereoScale& stereo);

}  // namespace rva
