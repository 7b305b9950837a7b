// Several views from nearly one place as a single, better one.
#pragma once

#include <vector>

#include "cloud/depth_view.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// A view, and where it was taken.
struct PlacedView {
  DepthView view;
  Transform first_from_view = Transform::Identity();
};

/// What a matcher gets wrong depends on which dots fall on a surface, and stays however many frames are
/// taken; views that differ by a few degrees have other dots there. Each pixel of the result, in the first
/// view's camera, is the mean of what the views have there, but those that lie off the median by more than an
/// edge would; there must be half of the views at least.
/// @param views at least one
/// @return deviation_px between the views where there are several of them, else that of the only view
[[nodiscard]] DepthView fuse(const std::vector<PlacedView>& views);

}  // namespace rva
