// Changes seen from nearly one place as a single, better one.
#pragma once

#include <vector>

#include "detect/calibrated/disparity_change.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// What changed between two captures of one pose, and where that was.
struct PlacedChange {
  DisparityChange change;
  Transform first_from_view = Transform::Identity();
};

/// Pixel by pixel, what the matcher gets wrong goes away where a camera comes back exactly, and so does what
/// a small thing shows where no dot falls on it. A few servo steps aside other dots do: each pixel of the
/// result, in the first view, is the mean of the changes that the views have on that surface, less each one's
/// drift; half of the views at least must have it. What was lost is that of the first view.
/// @param changes        at least one, all of `camera`
/// @param disparity_m_px focal length times baseline
[[nodiscard]] DisparityChange fuse(std::vector<PlacedChange> changes, const Intrinsics& camera,
                                   double disparity_m_px);

}  // namespace rva
