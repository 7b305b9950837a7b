// How well two views hold an alignment.
#pragma once

#include "cloud/agreement.hpp"

namespace rva {

/// Of a small rotation vector (rad) and translation (m) in the initial camera's frame, in this order.
using PoseCovariance = Eigen::Matrix<double, 6, 6>;

struct RegistrationUncertainty {
  PoseCovariance covariance = PoseCovariance::Zero();
  double distance_m = 1.0;  ///< of what the final view shows: its median depth
  /// Deviation along the direction that is held worst, metres at that distance.
  double worst_m = 0.0;
  /// That direction, as a covariance's: a unit vector of rotation (times the distance) and translation.
  Eigen::Matrix<double, 6, 1> worst = Eigen::Matrix<double, 6, 1>::Zero();
};

/// Residuals of one surface err together, for matching errs by how a surface lies: the covariance is a
/// sandwich over tiles of the image within which anything may agree (Liang and Zeger 1986). What holds an
/// alignment is taken from slopes of both views, whose noise has nothing in common: slopes that are noise
/// hold nothing, so that a bare wall is told from one with structure.
[[nodiscard]] RegistrationUncertainty uncertainty(const ViewPair& views, const Alignment& alignment,
                                                  double reach_px);

}  // namespace rva
