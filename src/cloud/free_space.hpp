// What changed between two views of cameras that stood in different places, by the space that each saw
// through.
#pragma once

#include "cloud/depth_view.hpp"
#include "detect/calibrated/disparity_change.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// What the final view has, against what the initial one has there, as the static comparison takes it: in
/// pixels of the final camera's disparity. A final point in front of what the initial camera saw along its
/// ray through that point has come; one behind it was hidden before, and is `unseen` (no disparity before). A
/// surface of the initial view that the final camera sees through has gone.
/// @param offset_px disparity of the initial camera against the final one, taken off first
[[nodiscard]] DisparityChange free_space_change(const DepthView& initial, const DepthView& final,
                                                const Transform& initial_from_final, double offset_px);

}  // namespace rva
