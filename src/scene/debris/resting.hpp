// Resting poses of debris under gravity.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "scene/ray_caster.hpp"
#include "scene/scene.hpp"

namespace rva {

/// An orientation in which a rigid body is stable on a level floor.
struct RestingOrientation {
  Eigen::Matrix3d floor_from_body;  ///< turns the body so that its support faces down (-z)
  /// Convex polygon on which the body stands: metres, counterclockwise, in the floor frame with the centre of
  /// mass as origin.
  std::vector<Eigen::Vector2d> support;
  double height_m;     ///< centre of mass above the floor
  double probability;  ///< share of tumbles that end in it (by the solid angle of its face); all sum to 1
};

/// Stable orientations, most probable first: the faces of the convex hull that lie below the centre of mass
/// (the origin of the parts). A round body rests on the facets of its mesh.
[[nodiscard]] std::vector<RestingOrientation> resting_orientations(std::span<const Part> parts);

/// Lowers a body straight down until it touches the surface, and checks that it is stable there.
/// @param surface     the scene without the body
/// @param orientation one of resting_orientations()
/// @param turn_deg    about the vertical, counterclockwise seen from above
/// @param place_m     world x and y of the centre of mass, and the z from which the body is lowered
/// @return world_from_body; empty if there is nothing below, if the surface does not support the centre of
///         mass (an edge, a slope) or if the body would intersect something
[[nodiscard]] std::optional<Transform> put_down(const RayCaster& surface, std::span<const Part> parts,
                                                const RestingOrientation& orientation, double turn_deg,
                                                const Eigen::Vector3d& place_m);

}  // namespace rva
