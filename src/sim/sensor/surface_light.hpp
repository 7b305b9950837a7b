// The reflection of light by a surface.
#pragma once

#include <Eigen/Core>

#include "scene/material.hpp"

namespace rva {

/// A point on a surface and the direction from which it is seen.
struct SurfacePoint {
  Eigen::Vector3f position;  ///< world, metres
  Eigen::Vector3f normal;    ///< unit, towards the eye
  Eigen::Vector3f to_eye;    ///< unit
};

/// A smooth random field with values in [-1, 1], interpolated on a lattice with a spacing of one unit.
[[nodiscard]] float value_noise(const Eigen::Vector3f& position);

/// The factor of the surface's own texture at a position: a smooth random field of the material's contrast
/// and size with a mean of 1, darker where there is dirt.
[[nodiscard]] float grain_at(const Material& material, const Eigen::Vector3f& position);

/// Light towards the eye, per unit of light from one direction: diffuse (Lambert) and glossy (Blinn 1977,
/// normalised). A white, matt surface that faces the light yields 1.
/// @param albedo   diffuse reflectance, grain included
/// @param to_light unit vector
/// @return the reflected share, with the cosine of the angle of incidence; 0 for light from behind
[[nodiscard]] float reflected(const Material& material, float albedo, const SurfacePoint& point,
                              const Eigen::Vector3f& to_light);

/// Light towards the eye from surroundings that are bright above and dark below. A glossy surface mirrors
/// them, so its appearance depends on the position of the eye.
[[nodiscard]] float reflected_surroundings(const Material& material, float albedo, const SurfacePoint& point);

}  // namespace rva
