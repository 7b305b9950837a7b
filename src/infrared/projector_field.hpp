// How far the projector's light reaches in an infrared image.
#pragma once

#include "depth/image.hpp"

namespace rva {

/// Infrared images are not compared so near to where the projector's light ends, which moves over the scene
/// with the camera.
inline constexpr int beside_field_px = 15;

/// Set where an image has no dots, and beside it: by six pixels, and by `beside_field_px` where it is dark up
/// to the image's border. There the projector's field ends. A dark part within the field is a hole, beside
/// which things lie.
/// @param dots as of dot_mask()
[[nodiscard]] Mask without_dots(const Mask& dots);

/// Set where neither dots nor other light fall, up to the image's border, and beside it. Depth that a matcher
/// gives there is made of noise.
/// @param log_image as of log_grey()
/// @param dots      as of dot_mask()
/// @param beside_px is added around; without it, the area begins six to nine pixels beyond the last dots
[[nodiscard]] Mask beyond_projector(const Image<float>& log_image, const Mask& dots, int beside_px);

}  // namespace rva
