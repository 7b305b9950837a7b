// Flat outlines given a thickness.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/scene/mesh.hpp"

namespace rva {

/// Corners, counterclockwise, also those of a hole.
using Outline = std::vector<Eigen::Vector2d>;

/// An ellipse, from the end of its axis along +x.
[[nodiscard]] Outline ellipse(const Eigen::Vector2d& center_m, double radius_u_m, double radius_v_m,
                              int corners);

/// An outline, which may be concave, moved along z from 0 to `length_m`, with holes through it.
/// @param holes apart from each other and from the outline
[[nodiscard]] TriangleMesh extrude(std::span<const Eigen::Vector2d> outline_m,
                                   std::span<const Outline> holes_m, double length_m);

}  // namespace rva
