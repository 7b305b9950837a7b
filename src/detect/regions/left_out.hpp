// Transfers the regions left out in the baseline to the view of a later capture.
#pragma once

#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// Set where a point of the final view projects onto a pixel that is left out in the initial image. If both
/// views have the same pose and camera, the mask is returned unchanged, including pixels without depth.
/// @param left_out mask of the initial depth image
/// @param final_m  depth after, metres; 0 where not measured
/// @return mask of the final depth image
[[nodiscard]] Mask carry_over(const Mask& left_out, const Intrinsics& initial, const Intrinsics& final,
                              const Image<float>& final_m, const Transform& initial_from_final);

}  // namespace rva
