// One view as another camera would see it.
#pragma once

#include "cloud/depth_view.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// The surfaces that a view saw, in the disparity of another camera; the nearest where several lie behind
/// each other, 0 where there is none. Neighbouring pixels span a surface unless an edge runs between them.
[[nodiscard]] Image<float> render(const DepthView& view, const Intrinsics& camera, double disparity_m_px,
                                  const Transform& camera_from_view);

}  // namespace rva
