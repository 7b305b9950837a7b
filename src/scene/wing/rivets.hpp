// Rows of rivet heads, the typical repetitive structure of a wing.
#pragma once

#include <Eigen/Core>

#include "scene/solids/mesh.hpp"

namespace rva {

/// Dome heads of 5 mm diameter that face up (+z), evenly spaced by 35 mm or more along a level line; none if
/// the line is shorter than that.
/// @param from_m one end of the line, on the sheet
/// @param to_m   the other end
[[nodiscard]] TriangleMesh rivet_row(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m);

}  // namespace rva
