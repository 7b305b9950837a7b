// What a person left out on the baseline's picture, in the view of a later capture.
#pragma once

#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// Set where the final camera sees a point that projects onto a pixel which is left out in the initial image.
/// Where both views are one, the mask itself, pixels without a depth included.
/// @param left_out of the initial depth image
/// @param final_m  depth after, metres; 0 where not measured
/// @return of the final depth image
[[nodiscard]] Mask carry_over(const Mask& left_out, const Intrinsics& initial, const Intrinsics& final,
                              const Image<float>& final_m, const Transform& initial_from_final);

}  // namespace rva
