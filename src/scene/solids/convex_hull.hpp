// Convex hulls in space and in the plane.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rva {

/// Triangles of the hull in space, as indices into the points, counterclockwise seen from outside; empty if
/// the points lie in one plane. Flat faces consist of several triangles, some of which are slivers along
/// their edges.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> convex_hull(std::span<const Eigen::Vector3d> points);

/// Corners of the hull in the plane, counterclockwise; fewer than three if the points lie on one line.
[[nodiscard]] std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

/// Distance from a point inside a convex polygon to its nearest edge; negative outside, and minus infinity
/// for fewer than three corners.
/// @param polygon corners, counterclockwise
[[nodiscard]] double depth_inside(std::span<const Eigen::Vector2d> polygon, const Eigen::Vector2d& point);

}  // namespace rva
