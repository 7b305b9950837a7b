// Where a projector's dots cover an infrared image.
#pragma once

#include "depth/image.hpp"

namespace rva {

/// Speckle and the surface's own brightness multiply light: in the logarithm, both are the same everywhere.
/// @param grey levels of 8 bits, 0 to 255, with fractions
/// @param scale by which grey levels are multiplied first
/// @return log(grey + 3); the 3 keeps the noise of what is dark within bounds
[[nodiscard]] Image<float> log_grey(const Image<float>& grey, float scale = 1.0F);

/// A dot is narrower than 7 pixels and brighter than what is around it by more than the image's own noise
/// explains: the image, smoothed by 0.7 pixels, less its opening by 7 x 7, over 0.1 and 2.5 deviations.
/// Widened by a pixel.
/// @param log_image as of log_grey()
[[nodiscard]] Mask dot_mask(const Image<float>& log_image);

}  // namespace rva
