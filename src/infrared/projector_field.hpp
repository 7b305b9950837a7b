// Detects how far the light of the projector reaches in an infrared image.
#pragma once

#include "depth/image.hpp"

namespace rva {

/// Distance from the edge of the projector's field within which infrared images are not compared, since the
/// field moves over the scene with the camera.
inline constexpr int beside_field_px = 15;

/// Set where an image has no dots, and within six pixels of that, or within `beside_field_px` if the area
/// without dots reaches the border of the image, where the field of the projector ends. A dark area inside
/// the field is a hole, with objects close to it.
/// @param dots as returned by dot_mask()
[[nodiscard]] Mask without_dots(const Mask& dots);

/// Set where neither dots nor other light fall, in areas that reach the border of the image, and around them.
/// Depth that a matcher reports there is computed from noise.
/// @param log_image as returned by log_grey()
/// @param dots      as returned by dot_mask()
/// @param beside_px by how much the area is dilated; without it, it begins six to nine pixels beyond the
///                  last dots
[[nodiscard]] Mask beyond_projector(const Image<float>& log_image, const Mask& dots, int beside_px);

}  // namespace rva
