// Values as colours, for people.
#pragma once

#include <string_view>

#include "depth/image.hpp"

namespace rva {

/// The range of values that the colours span; values beyond it take the end colours.
struct ColorScale {
  float low = 0.0F;
  float high = 1.0F;
};

/// OpenCV's jet colours, blue at `low` to red at `high`; black where the value is NaN.
[[nodiscard]] ColorImage colorize(const Image<float>& values, ColorScale scale);

/// The same image with a bar at its right side: the colours from low (bottom) to high (top), labelled with
/// their values.
/// @param title what the values are, with their unit, written above the bar; ASCII
[[nodiscard]] ColorImage with_scale_bar(const ColorImage& image, ColorScale scale, std::string_view title);

/// The range from 0 to a round number that all but a twentieth of the values stay below: the few at depth
/// edges are larger by so much that a scale for all would show nothing else.
[[nodiscard]] ColorScale scale_from_zero(const Image<float>& values);

/// Of depths in metres: tenths of a metre that all but a fiftieth are farther than, and all but a tenth
/// nearer: the few that lie far behind a bay would leave one colour to all that is in it.
[[nodiscard]] ColorScale scale_of_depth(const Image<float>& depth_m);

/// The range between round numbers that all but a hundredth at either end lie in.
[[nodiscard]] ColorScale scale_around(const Image<float>& values);

}  // namespace rva
