// Fuses several views from nearly one pose.
#pragma once

#include <vector>

#include "geometry/transform.hpp"
#include "views/depth_view.hpp"

namespace rva {

/// A view and its pose.
struct PlacedView {
  DepthView view;                                     ///< what was measured
  Transform first_from_view = Transform::Identity();  ///< pose of the view in the frame of the first one
};

/// Fuses views into the camera of the first one. The errors of a matcher depend on which dots fall on a
/// surface, and do not decrease with the number of frames; views that differ by a few degrees have other dots
/// there. Each pixel of the result is the mean of the disparities of the views, without those that differ
/// from the median by more than an edge would; at least half of the views must remain.
/// @param views at least one
/// @return deviation_px is the deviation between the views if there are several, else that of the only view
[[nodiscard]] DepthView fuse(const std::vector<PlacedView>& views);

}  // namespace rva
