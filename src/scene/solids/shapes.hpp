// Solids for scenes. All are closed, face outward and are in metres.
#pragma once

#include <Eigen/Core>
#include <span>

#include "scene/solids/mesh.hpp"

namespace rva {

/// A box along the axes, centred on the origin.
/// @param size_m edge lengths, all positive
[[nodiscard]] TriangleMesh box(const Eigen::Vector3d& size_m);

/// An outline, which may be concave, extruded along z from 0 to `length_m`.
/// @param outline_m at least three corners, counterclockwise seen from +z
[[nodiscard]] TriangleMesh prism(std::span<const Eigen::Vector2d> outline_m, double length_m);

/// A solid of revolution about the z axis. For a ring, use tube() or turned_ring().
/// @param profile_rz_m corners (r, z), r >= 0, from the bottom to the top along the outside; an end at r > 0
///                     is closed by a disc
/// @param segments     flat pieces around the axis, at least 3
[[nodiscard]] TriangleMesh lathe(std::span<const Eigen::Vector2d> profile_rz_m, int segments);

/// A cylinder along z, centred on the origin.
[[nodiscard]] TriangleMesh cylinder(double radius_m, double length_m, int segments);

/// A cylinder with a bore along z, centred on the origin.
/// @param outer_corners corners of the outer surface; 0 for `segments`, 6 for a nut
[[nodiscard]] TriangleMesh tube(double outer_radius_m, double inner_radius_m, double length_m, int segments,
                                int outer_corners = 0);

/// A round rod along a polyline, closed at both ends.
/// @param path_m at least two points, no two neighbours equal
[[nodiscard]] TriangleMesh rod(std::span<const Eigen::Vector3d> path_m, double radius_m, int segments);

/// A hole through a plate.
struct RoundHole {
  Eigen::Vector2d center_m;  ///< centre in x and y, metres
  double radius_u_m;         ///< half its extent along x
  double radius_v_m;         ///< half its extent along y
};

/// A plate in x and y, centred on the origin, with elliptic holes along z.
/// @param holes must not touch each other or the edge
[[nodiscard]] TriangleMesh plate(const Eigen::Vector3d& size_m, std::span<const RoundHole> holes);

/// A thin sheet such as cloth over a grid of heights, which is its underside; its top is `thickness_m`
/// higher.
/// @param heights_m  row by row, `columns` per row, at least 2 x 2
/// @param pitch_m    distance between neighbours in x and y; the grid is centred on the origin
[[nodiscard]] TriangleMesh sheet(std::span<const double> heights_m, int columns, double pitch_m,
                                 double thickness_m);

}  // namespace rva
