// The height of a finding above the surface around it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "depth/image.hpp"

namespace rva {

/// Depth images in which a region's object is and is not, pixel upon pixel; metres along z, 0 where not
/// measured.
struct BeforeAndAfter {
  const Image<float>& with_object_m;
  const Image<float>& without_m;
};

/// How far a region stands out of the surface around it, millimetres along z: the median over the region of
/// the distance to a plane through the pixels of a ring around it. The change of depth of the same region may
/// be much larger: at an edge, a farther surface was seen there before.
///
/// The ring leaves out a gap of pixels in which a stereo matcher mixes object and surroundings, and pixels
/// that changed. If it shows several planes, the object is taken to lie on the one behind it that is nearest.
/// @param pixels  the region, as indices in row-major order
/// @param changed every changed pixel, including the region
/// @return above 0; empty where less than half of the region or a third of the ring is measured, where the
///         ring has no plane, or where the region does not stand out
[[nodiscard]] std::optional<double> height_above_surroundings_mm(std::span<const std::uint32_t> pixels,
                                                                 const BeforeAndAfter& depth,
                                                                 const Mask& changed);

/// Whether a region's depth changed by so much more than its height above the surroundings that a farther
/// surface must have been seen there: by more than twice that height and 10 mm.
/// @param change_mm in magnitude
[[nodiscard]] bool is_background_jump(double change_mm, double above_surroundings_mm);

}  // namespace rva
