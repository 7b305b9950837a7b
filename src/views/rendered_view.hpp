// Renders a view as another camera would see it.
#pragma once

#include "geometry/stereo_scale.hpp"
#include "geometry/transform.hpp"
#include "views/depth_view.hpp"

namespace rva {

/// The surfaces of a view as disparity in another camera: the nearest one along each ray, 0 where there is
/// none. Neighbouring pixels span a surface unless there is an edge between them.
[[nodiscard]] Image<float> render(const DepthView& view, const Intrinsics& camera, const StereoScale& stereo,
                                  const Transform& camera_from_view);

}  // namespace rva
