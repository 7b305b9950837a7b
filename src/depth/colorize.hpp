// Rendering of values as colours.
#pragma once

#include <string_view>

#include "depth/image.hpp"

namespace rva {

/// The range of values that the colours span; values beyond it have the colour of the nearer end.
struct ColorScale {
  float low = 0.0F;   ///< value with the first colour
  float high = 1.0F;  ///< value with the last colour
};

/// Colours of values from low to high. Both run from blue to red.
enum class ColorMap {
  turbo,  ///< equal steps look about equal (Mikhailov 2019); without the darkest ends, which look like black
  jet,    ///< of the thesis' figures; shows edges at yellow and cyan where the values have none
};

/// The colours of values; black where the value is NaN.
[[nodiscard]] ColorImage colorize(const Image<float>& values, ColorScale scale,
                                  ColorMap map = ColorMap::turbo);

/// The same image with a legend at its right side: a title above a bar of the colours from low (bottom) to
/// high (top), with ticks at round values. The image's pixels stay where they are.
/// @param title what the values are, with their unit; ASCII; a line for each line of the text
[[nodiscard]] ColorImage with_legend(const ColorImage& image, ColorScale scale, std::string_view title,
                                     ColorMap map = ColorMap::turbo);

/// The range from 0 to the 90th percentile of the values, rounded up: the few values at depth edges and on
/// what is far behind a bay are so much larger that a scale including them would show nothing else.
[[nodiscard]] ColorScale scale_from_zero(const Image<float>& values);

/// The range of depth from the 2nd to the 90th percentile, widened to whole tenths of a metre: with the few
/// pixels far behind a bay included, everything in the bay would have the same colour.
[[nodiscard]] ColorScale scale_of_depth(const Image<float>& depth_m);

}  // namespace rva
