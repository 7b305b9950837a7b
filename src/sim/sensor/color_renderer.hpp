// What the colour imager beside the infrared ones sees.
#pragma once

#include <cstdint>

#include "depth/image.hpp"
#include "sim/scene/ray_caster.hpp"
#include "sim/scene/scene.hpp"
#include "sim/sensor/stereo_rig.hpp"

namespace rva {

/// Light on the colour imager, before noise: red, green and blue, 1 is white.
struct ColorView {
  Image<float> red;
  Image<float> green;
  Image<float> blue;
};

/// @param supersampling rays a pixel along each side
/// @throws Interrupted when a person stops the program meanwhile
[[nodiscard]] ColorView render_color(const Scene& scene, const RayCaster& rays, const StereoRig& rig,
                                     const Transform& world_from_depth, int supersampling);

/// One picture of the view: noise, 8 bits, gamma. A dark wing gives a nearly black picture, not an empty one.
[[nodiscard]] ColorImage expose_color(const ColorView& view, std::uint64_t seed);

}  // namespace rva
