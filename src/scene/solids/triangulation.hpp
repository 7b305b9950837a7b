// Triangulation of flat regions with holes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rva {

/// Corners as indices into a list of points, with the region on the left of each edge: an outer loop runs
/// counterclockwise, a hole clockwise.
using Loop = std::vector<std::uint32_t>;

/// Triangulates a region without adding corners; triangles are counterclockwise.
/// @param loops the outline, which may be concave, then the holes; they must neither touch nor cross
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Eigen::Vector2d> points,
                                                                    std::span<const Loop> loops);

}  // namespace rva
