// Ranges of the joints.
#pragma once

#include "geometry/pan_tilt.hpp"

namespace rva {

/// The range of one joint; both ends can be reached.
struct AxisLimits {
  double min_deg = 0.0;  ///< least angle
  double max_deg = 0.0;  ///< greatest angle
  bool operator==(const AxisLimits&) const = default;
};

/// The limits of the thesis' robot, whose upward tilt the camera's cable restricts. Larger limits reported by
/// a robot are rejected.
struct RobotLimits {
  AxisLimits pan{-90.0, 90.0};  ///< positive is to the left
  AxisLimits tilt{-90.0, 9.0};  ///< positive is up
  bool operator==(const RobotLimits&) const = default;

  /// Refuses a target that cannot be reached.
  /// @throws UsageError naming the axis and its limits when the target is beyond them or not a number
  void check(const PanTilt& target) const;

  /// The nearest angles within the limits: a joint that was turned by hand may be slightly beyond them.
  [[nodiscard]] PanTilt nearest(const PanTilt& joints) const;
};

}  // namespace rva
