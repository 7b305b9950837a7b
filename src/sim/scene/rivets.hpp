// Rows of rivet heads: the repeated structure that a stereo camera meets in a wing.
#pragma once

#include <Eigen/Core>

#include "sim/scene/mesh.hpp"

namespace rva {

/// Domes of 5 mm, 35 mm apart, that look up (+z), evenly along a level line; none where the line is too
/// short.
/// @param from_m one end of the line, on the sheet
/// @param to_m   the other
[[nodiscard]] TriangleMesh rivet_row(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m);

}  // namespace rva
