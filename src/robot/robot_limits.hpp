// How far the joints turn.
#pragma once

#include "geometry/pan_tilt.hpp"

namespace rva {

/// Both ends are within reach.
struct AxisLimits {
  double min_deg = 0.0;
  double max_deg = 0.0;
  bool operator==(const AxisLimits&) const = default;
};

/// The thesis' robot: up, the camera's cable ends the way early. No robot is believed that claims more.
struct RobotLimits {
  AxisLimits pan{-90.0, 90.0};
  AxisLimits tilt{-90.0, 9.0};
  bool operator==(const RobotLimits&) const = default;

  /// @throws UsageError naming the axis and its limits when the target is beyond them or not a number
  void check(const PanTilt& target) const;

  /// Within reach: a joint that was turned by hand may stand a little beyond its limits.
  [[nodiscard]] PanTilt nearest(const PanTilt& joints) const;
};

}  // namespace rva
