// Rigid transforms between frames.
//
// A transform `a_from_b` takes coordinates in b to coordinates in a, as the thesis writes its arrows
// (equation 2.1), so that neighbours in a product match: `world_from_camera * camera_from_depth`.
// Camera frames: x right, y down, z forward, origin in the imager's centre of projection. Metres.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>

namespace rva {

/// Rotation and translation (equation 2.2), translation in metres.
using Transform = Eigen::Isometry3d;

/// The 4x4 matrix as files carry it: 16 numbers, row by row.
[[nodiscard]] std::array<double, 16> to_row_major(const Transform& a_from_b);

/// The transform of a 4x4 matrix as files carry it.
/// @param numbers 16 numbers, row by row
/// @throws Error when they are not finite, the upper left 3x3 is not a rotation (to 1e-3, since files contain
///         rounded numbers), or the last row is not 0 0 0 1. The rotation returned is exactly orthonormal.
[[nodiscard]] Transform from_row_major(std::span<const double, 16> numbers);

}  // namespace rva
