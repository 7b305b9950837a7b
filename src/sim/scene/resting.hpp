// Debris lies as gravity leaves it.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "sim/scene/ray_caster.hpp"
#include "sim/scene/scene.hpp"

namespace rva {

/// An orientation in which a rigid body stays put on a level floor.
struct RestingOrientation {
  Eigen::Matrix3d floor_from_body;       ///< turns the body so that its support faces down (-z)
  std::vector<Eigen::Vector2d> support;  ///< convex polygon on which it stands, floor frame around the centre
                                         ///< of mass, counterclockwise, metres
  double height_m;                       ///< centre of mass above the floor
  double probability;  ///< share of tumbles that end so (solid angle of its face, all sum to 1)
};

/// The faces of the convex hull over which the centre of mass (the origin of the parts) lies, most probable
/// first. A body that rolls is held by the facets of its mesh.
[[nodiscard]] std::vector<RestingOrientation> resting_orientations(std::span<const Part> parts);

/// Lowers a body straight down until it touches, and says whether it stays there.
/// @param surface     what is below, without the body
/// @param orientation one of resting_orientations()
/// @param turn_deg    about the vertical, counterclockwise seen from above
/// @param place_m     world x and y of the centre of mass, and a z from which to look down
/// @return world_from_body; empty where there is nothing below, where the surface does not carry the centre
/// of
///         mass (an edge, a slope) or where the body would cut into something
[[nodiscard]] std::optional<Transform> put_down(const RayCaster& surface, std::span<const Part> parts,
                                                const RestingOrientation& orientation, double turn_deg,
                                                const Eigen::Vector3d& place_m);

}  // namespace rva
