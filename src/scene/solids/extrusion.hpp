// Extrusion of flat outlines.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "scene/solids/mesh.hpp"

namespace rva {

/// Corners in counterclockwise order, for holes as well.
using Outline = std::vector<Eigen::Vector2d>;

/// An ellipse; its first corner is in the direction of +x from its centre.
[[nodiscard]] Outline ellipse(const Eigen::Vector2d& center_m, double radius_u_m, double radius_v_m,
                              int corners);

/// An outline, which may be concave, extruded along z from 0 to `length_m`, with holes through it.
/// @param holes_m must not touch each other or the outline
[[nodiscard]] TriangleMesh extrude(std::span<const Eigen::Vector2d> outline_m,
                                   std::span<const Outline> holes_m, double length_m);

}  // namespace rva
