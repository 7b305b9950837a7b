// The part of a picture in which a finding is classified.
#pragma once

#include "depth/image.hpp"
#include "detect/regions/regions.hpp"

namespace rva {

/// A square about a finding, twice as wide as its box and at least 32 pixels wide, moved so that it lies
/// within the picture and cut off where the picture is smaller.
/// @param box    of the finding; may reach beyond the picture
/// @param width  of the picture, pixels, at least 1
/// @param height of the picture, pixels, at least 1
[[nodiscard]] Box surroundings_of(const Box& box, int width, int height);

/// A part of a picture. @param part lies within it
[[nodiscard]] ColorImage part_of(const ColorImage& picture, const Box& part);

}  // namespace rva
