// Gives the servos of a robot that is being assembled the IDs of their joints.
#pragma once

#include <string_view>

#include "robot/serial_robot.hpp"

namespace rva {

/// A joint, as the ID that its servo has (docs/protocol.md). Servos are delivered with ID 253.
enum class ServoJoint { pan = 1, tilt = 2 };

/// "pan" or "tilt".
[[nodiscard]] std::string_view name_of(ServoJoint joint);

/// Gives the only servo that is connected the ID of a joint, for good, and checks that it answers to it. With
/// several servos connected, nobody could state which one is which.
/// @return the ID that the servo had, which may be the same
/// @throws Error when no servo or several are connected, when the servo does not answer to its new ID, and as
///         SerialRobot::find_servos()
int set_up_servo(SerialRobot& robot, ServoJoint joint);

}  // namespace rva
