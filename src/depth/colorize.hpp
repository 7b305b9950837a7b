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

/// OpenCV's jet colours, blue at `low` to red at `high`; black where the value is NaN.
[[nodiscard]] ColorImage colorize(const Image<float>& values, ColorScale scale);

/// The same image with a bar at its right side: the colours from low (bottom) to high (top), labelled with
/// their values.
/// @param title what the values are, with their unit, written above the bar; ASCII
[[nodiscard]] ColorImage with_scale_bar(const ColorImage& image, ColorScale scale, std::string_view title);

/// The range from 0 to the 95th percentile of the values, rounded up: the few values at depth edges are so
/// much larger that a scale including them would show nothing else.
[[nodiscard]] ColorScale scale_from_zero(const Image<float>& values);

/// The range of depth from the 2nd to the 90th percentile, widened to whole tenths of a metre: with the few
/// pixels far behind a bay included, everything in the bay would have the same colour.
[[nodiscard]] ColorScale scale_of_depth(const Image<float>& depth_m);

/// The range from the 1st to the 99th percentile of the values, widened to round numbers.
[[nodiscard]] ColorScale scale_around(const Image<float>& values);

}  // namespace rva
