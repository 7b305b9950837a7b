// Uncertainty of an alignment of two views.
#pragma once

#include "geometry/rigid_motion.hpp"
#include "views/normal_equations.hpp"

namespace rva {

/// The covariance of a registration and its least constrained direction.
struct RegistrationUncertainty {
  /// Of the twist in the initial camera's frame by which the true pose differs: it is
  /// exp_of(twist) * initial_from_final.
  TwistMatrix covariance = TwistMatrix::Zero();
  double distance_m = 1.0;  ///< median depth of the final view
  /// Standard deviation along the least constrained direction, metres at that distance.
  double worst_m = 0.0;
  /// That direction: a unit vector of rotation (times the distance) and translation.
  Twist worst = Twist::Zero();
};

/// Residuals of one surface are correlated, because the error of matching depends on the orientation of the
/// surface. The covariance is therefore a sandwich estimate over tiles of the image, within which residuals
/// may be correlated in any way (Liang and Zeger 1986). The information is a product of the slopes of both
/// views, whose noise is independent: slopes that are mere noise contribute no information, so that a bare
/// wall is distinguished from structure.
[[nodiscard]] RegistrationUncertainty uncertainty(const ViewPair& views, const Alignment& alignment,
                                                  double reach_px);

}  // namespace rva
