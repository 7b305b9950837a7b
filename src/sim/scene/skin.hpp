// Surfaces stretched over rings of points: what turned parts, rods and ribbons have in common.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/scene/mesh.hpp"

namespace rva {

/// Points around a body, counterclockwise seen from the side of the next ring; a single point is a tip.
using Ring = std::vector<Eigen::Vector3d>;

/// Joins neighbours among the rings and closes both ends over the middle of their ring.
/// @param rings at least two; those that are no tips have one number of points
[[nodiscard]] TriangleMesh skin(std::span<const Ring> rings);

/// Joins neighbours among the rings, and the last one to the first.
/// @param rings at least three, none of them a tip
[[nodiscard]] TriangleMesh looped_skin(std::span<const Ring> rings);

/// A profile turned about the z axis into a ring, so that the axis stays free.
/// @param loop_rz_m corners (r, z), r > 0: up along the outside, back down along the bore
[[nodiscard]] TriangleMesh turned_ring(std::span<const Eigen::Vector2d> loop_rz_m, int segments);

}  // namespace rva
