// Checks of a robot.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/clock.hpp"
#include "doctor/checkup.hpp"
#include "robot/robot.hpp"
#include "robot/serial_robot.hpp"

namespace rva {

/// A robot that was opened for its checks.
struct OpenedRobot {
  std::unique_ptr<Robot> robot;   ///< not null
  SerialRobot* serial = nullptr;  ///< the same robot, if it is on a serial line; null if it is simulated
};

/// Opens the robot. @throws Error; UsageError when there is no such kind of robot
using OpensRobot = std::function<OpenedRobot()>;

/// The names of the checks of examine_robot(), in their order.
[[nodiscard]] std::vector<std::string> robot_check_names();

/// Checks "robot", "robot-firmware", "servos", "stop", "lamp". Errors of the robot are results.
/// @param may_move whether "stop" may turn the pan joint by up to 20 degrees and back
/// @param clock    by which the robot moves
/// @throws UsageError as `open`; Interrupted: the robot is stopped before
[[nodiscard]] CheckedItems examine_robot(const OpensRobot& open, bool may_move,
                                         const Clock& clock = steady_clock());

/// The check "robot-firmware" of a robot on a serial line.
/// @param version empty for a bare one
[[nodiscard]] CheckedItem robot_firmware_item(RobotKind kind, const std::string& version);

}  // namespace rva
