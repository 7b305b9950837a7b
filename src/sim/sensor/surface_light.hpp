// How a surface answers light.
#pragma once

#include <Eigen/Core>

#include "sim/scene/material.hpp"

namespace rva {

/// A place on a surface and who looks at it.
struct SurfacePoint {
  Eigen::Vector3f position;  ///< world, metres
  Eigen::Vector3f normal;    ///< unit, towards the eye
  Eigen::Vector3f to_eye;    ///< unit
};

/// A smooth random field with values in [-1, 1], a lattice of one unit apart.
[[nodiscard]] float value_noise(const Eigen::Vector3f& position);

/// The surface's own texture at a place: 1 on average, a smooth random field of the material's contrast and
/// size, darker where dirt lies.
[[nodiscard]] float grain_at(const Material& material, const Eigen::Vector3f& position);

/// Light towards the eye for a unit of light that falls squarely on the surface from one direction: diffuse
/// (Lambert) and glossy (Blinn 1977, normalised). A white, matt surface gives 1.
/// @param albedo   diffuse, grain included
/// @param to_light unit
/// @return with the cosine of the light's angle; 0 from behind
[[nodiscard]] float reflected(const Material& material, float albedo, const SurfacePoint& point,
                              const Eigen::Vector3f& to_light);

/// Light towards the eye from all around, for surroundings that are bright above and dark below: a glossy
/// surface mirrors them, so its picture moves with the eye.
[[nodiscard]] float reflected_surroundings(const Material& material, float albedo, const SurfacePoint& point);

}  // namespace rva
