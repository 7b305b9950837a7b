#include "robot/robot_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace rva {
namespace {

void require_within(double angle_deg, const AxisLimits& limits, const char* axis) {
  if (angle_deg >= limits.min_deg && angle_deg <= limits.max_deg) return;  // false for NaN
  throw UsageError(fmt::format("robot's {}", axis), fmt::format("{} deg is out of range", angle_deg),
                   fmt::format("give {} to {} deg", limits.min_deg, limits.max_deg));
}

}  // namespace

void RobotLimits::check(const PanTilt& target) const {
  require_within(target.pan_deg, pan, "pan");
  require_within(target.tilt_deg, tilt, "tilt");
}

PanTilt RobotLimits::nearest(const PanTilt& joints) const {
  return {std::clamp(joints.pan_deg, pan.min_deg, pan.max_deg),
          std::clamp(joints.tilt_deg, tilt.min_deg, tilt.max_deg)};
}

}  // namespace rva
