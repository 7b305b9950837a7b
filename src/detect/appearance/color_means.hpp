// Mean light of a colour imager over the frames of a capture.
#pragma once

#include <array>
#include <optional>

#include "capture/capture.hpp"
#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"

namespace rva {

/// Images in the view of the colour imager, reduced to at most the width of the depth images.
struct ColorMeans {
  Intrinsics camera;                     ///< intrinsics of these images
  std::array<Image<float>, 3> channels;  ///< red, green and blue light, linear, 0 to 255
  Image<float> luminance;                ///< weighted sum of the three (ITU-R BT.709)
  Mask moving;                           ///< set where the frames differ from each other by more than noise
};

/// True if a capture has colour images, states the transform between the imagers, and neither has
/// lens distortion.
[[nodiscard]] bool has_comparable_color(const Capture& capture);

/// Computes means over some of the frames, evenly distributed over the capture.
/// @param capture     capture with has_comparable_color()
/// @param most_frames maximum number of frames to read
/// @return empty if no frame has a colour image
/// @throws Error when an image cannot be read or has another size than stated
[[nodiscard]] std::optional<ColorMeans> color_means(const Capture& capture, int most_frames = 8);

/// True if most of the view is neither dark nor saturated.
[[nodiscard]] bool is_well_lit(const ColorMeans& color);

}  // namespace rva
