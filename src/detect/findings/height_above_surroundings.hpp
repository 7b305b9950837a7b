// The height of a finding above the surface around it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"

namespace rva {

/// Depth images in which a region's object is and is not, pixel upon pixel; metres along z, 0 where not
/// measured.
struct BeforeAndAfter {
  const Image<float>& with_object_m;
  const Image<float>& without_m;
};

/// How far a region stands out of the surface around it.
struct HeightAboveSurroundings {
  double median_mm = 0.0;  ///< over the region, along z; above 0
  /// The 90th percentile over the region of the distance from the surface that the object lies on, at right
  /// angles to it. That surface is the nearest plane behind the region, of the ring or of what is seen where
  /// the object is not. Empty where there is none.
  std::optional<double> top_mm;
  /// Whether the object may be higher than its top: depth is missing in more than a fifth of the region, the
  /// region reaches the border of the image, or less than half of the ring (or of what is seen where the
  /// object is not) belongs to that surface, as at an edge.
  bool at_least = false;
};

/// Measures the distances of a region's pixels along z from a plane through the pixels of a ring around it.
/// The change of depth of the same region may be much larger: at an edge, a farther surface was seen there
/// before.
///
/// The ring leaves out a gap of pixels in which a stereo matcher mixes object and surroundings, and pixels
/// that changed. If it shows several planes, the object is taken to lie on the one behind it that is nearest.
/// @param pixels  the region, as indices in row-major order
/// @param changed every changed pixel, including the region
/// @param camera  of the depth images
/// @return empty where less than half of the region or a third of the ring is measured, where the
///         ring has no plane, or where the region does not stand out
[[nodiscard]] std::optional<HeightAboveSurroundings> height_above_surroundings(
    std::span<const std::uint32_t> pixels, const BeforeAndAfter& depth, const Mask& changed,
    const Intrinsics& camera);

/// Whether a region reaches the part of an image that is not judged, at its border, so that its object may
/// continue beyond.
/// @param pixels as indices in row-major order
[[nodiscard]] bool reaches_border(std::span<const std::uint32_t> pixels, int width, int height);

/// Whether a region's depth changed by so much more than its height above the surroundings that a farther
/// surface must have been seen there: by more than twice that height and 10 mm.
/// @param change_mm in magnitude
[[nodiscard]] bool is_background_jump(double change_mm, double above_surroundings_mm);

}  // namespace rva
