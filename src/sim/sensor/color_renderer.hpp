// The image of the colour imager beside the infrared ones.
#pragma once

#include <cstdint>

#include "depth/image.hpp"
#include "scene/ray_caster.hpp"
#include "scene/scene.hpp"
#include "sim/sensor/stereo_rig.hpp"

namespace rva {

/// Light on the colour imager before noise, in linear red, green and blue; 1 is white.
struct ColorView {
  Image<float> red;    ///< linear, 0 to 1
  Image<float> green;  ///< linear, 0 to 1
  Image<float> blue;   ///< linear, 0 to 1
};

/// Renders the view of the colour imager.
/// @param supersampling rays per pixel along each side
/// @param lamp share of the full light of the lamp beside the imagers, 0 to 1
/// @throws Interrupted when the user stops the program
[[nodiscard]] ColorView render_color(const Scene& scene, const RayCaster& rays, const StereoRig& rig,
                                     const Transform& world_from_depth, int supersampling, double lamp = 0.0);

/// One colour image of the view, with noise, gamma encoding and 8 bits per channel. A dark wing yields a
/// nearly black image, not an empty one.
[[nodiscard]] ColorImage expose_color(const ColorView& view, std::uint64_t seed);

}  // namespace rva
