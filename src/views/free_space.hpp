// Detects changes between two views of cameras at different poses, by the space that each saw through.
#pragma once

#include "geometry/transform.hpp"
#include "views/depth_view.hpp"
#include "views/disparity_change.hpp"

namespace rva {

/// Compares the final view with the initial one, in disparity at the pixels of the final camera. A final
/// point in front of the surface that the initial camera saw along its ray through that point was added. One
/// behind it was hidden before and is `unseen` (no disparity before). A surface of the initial view that the
/// final camera sees through was removed.
/// @param offset_px disparity of the initial camera relative to the final one, which is subtracted first
[[nodiscard]] DisparityChange free_space_change(const DepthView& initial, const DepthView& final,
                                                const Transform& initial_from_final, double offset_px);

}  // namespace rva
