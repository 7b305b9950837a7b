// Rigid motions as vectors: the exponential map of SE(3), its inverse, and the adjoint.
//
// A pose is corrected either in the frame that it leads to, `exp_of(twist) * a_from_b` with the twist in a,
// or in the frame that it comes from, `a_from_b * exp_of(twist)` with the twist in b. Small twists add up.
// Source: Sola, Deray, Atchuthan, "A micro Lie theory for state estimation in robotics", 2018, section on
// SE(3).
#pragma once

#include <Eigen/Core>

#include "geometry/transform.hpp"

namespace rva {

/// Rotation vector (rad), then translation (m), in this order, of a motion at constant angular and linear
/// velocity over one unit of time.
using Twist = Eigen::Matrix<double, 6, 1>;
/// A linear map of twists: an adjoint, or the covariance or information of a pose.
using TwistMatrix = Eigen::Matrix<double, 6, 6>;

/// The motion of a twist. Its rotation is that of the rotation vector; where there is one, the translation
/// follows an arc and differs from the last three numbers.
[[nodiscard]] Transform exp_of(const Twist& twist);

/// The inverse of exp_of().
/// @return the twist with the shortest rotation vector, of at most pi; either of the two at pi
[[nodiscard]] Twist log_of(const Transform& motion);

/// The angle by which a motion turns, 0 to 180 degrees.
[[nodiscard]] double angle_deg_of(const Transform& motion);

/// Takes a twist in b to the same motion in a: exp_of(adjoint(a_from_b) * twist) is
/// a_from_b * exp_of(twist) * b_from_a.
[[nodiscard]] TwistMatrix adjoint(const Transform& a_from_b);

}  // namespace rva
