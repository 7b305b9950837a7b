// Surfaces over rings of points, as turned parts, rods and ribbons have them.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "scene/solids/mesh.hpp"

namespace rva {

/// Points around a body, counterclockwise seen from the side of the next ring; a single point is a tip.
using Ring = std::vector<Eigen::Vector3d>;

/// Joins consecutive rings, and closes both ends with a fan around the centre of the ring.
/// @param rings at least two; all that are not tips have the same number of points
[[nodiscard]] TriangleMesh skin(std::span<const Ring> rings);

/// Joins consecutive rings, and the last ring to the first.
/// @param rings at least three of the same number of points, none of them a tip
[[nodiscard]] TriangleMesh looped_skin(std::span<const Ring> rings);

/// A ring of revolution about the z axis, open along the axis.
/// @param loop_rz_m corners (r, z), r > 0: up along the outside, down along the bore
[[nodiscard]] TriangleMesh turned_ring(std::span<const Eigen::Vector2d> loop_rz_m, int segments);

}  // namespace rva
