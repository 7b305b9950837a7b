// Detects the dots of a projector in infrared images.
#pragma once

#include "depth/image.hpp"

namespace rva {

/// The logarithm of brightness. Speckle and reflectance multiply light, so that in the logarithm their
/// contrast is independent of brightness.
/// @param grey  8-bit grey levels, 0 to 255, with fractions
/// @param scale factor applied to grey levels first
/// @return log(scale * grey + 3); the 3 limits the noise of dark pixels
[[nodiscard]] Image<float> log_grey(const Image<float>& grey, float scale = 1.0F);

/// Detects dots, which are narrower than 7 pixels and brighter than their surroundings by more than the noise
/// of the image explains: set where the image, smoothed by 0.7 pixels, exceeds its opening by 7 x 7 pixels by
/// more than 0.1 plus 2.5 deviations of the noise. The result is dilated by a pixel.
/// @param log_image as returned by log_grey()
[[nodiscard]] Mask dot_mask(const Image<float>& log_image);

}  // namespace rva
