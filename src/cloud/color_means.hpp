// The light that a colour imager saw, as means over the frames of a capture.
#pragma once

#include <array>
#include <optional>

#include "depth/capture.hpp"
#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"

namespace rva {

/// In the colour imager's view, no wider than the depth images: what is finer is averaged.
struct ColorMeans {
  Intrinsics camera;                     ///< of these images
  std::array<Image<float>, 3> channels;  ///< red, green and blue light, linear, 0 to 255
  Image<float> luminance;                ///< of the three together (ITU-R BT.709)
  Mask moving;                           ///< set where the frames differ among themselves by more than noise
};

/// True when a capture has colour images, states where the colour imager stands, and neither lens bends rays.
[[nodiscard]] bool has_comparable_color(const Capture& capture);

/// The means of some of the capture's frames, evenly spread over it.
/// @param capture     has_comparable_color()
/// @param most_frames to read
/// @return empty when no frame has a colour image
/// @throws Error when an image cannot be read or has another size than stated
[[nodiscard]] std::optional<ColorMeans> color_means(const Capture& capture, int most_frames = 8);

/// True when the view is neither dark nor saturated for the most part.
[[nodiscard]] bool is_well_lit(const ColorMeans& color);

}  // namespace rva
