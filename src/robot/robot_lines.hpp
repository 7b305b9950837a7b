// The host's side of docs/protocol.md: frames to the robot, and what its lines say.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "geometry/pan_tilt.hpp"
#include "robot/robot_limits.hpp"

namespace rva {

/// A frame with its number and checksum, end included.
/// @param number 0 to 255
/// @param body   a verb and its arguments
[[nodiscard]] std::string robot_frame(int number, std::string_view body);

/// MOVE's body: angles with two decimals.
[[nodiscard]] std::string move_body(const PanTilt& target);

struct ReadyLine {
  int protocol = 0;
  std::string firmware;
  RobotLimits limits;
};

/// ACK, or NAK with its reason.
struct AnswerLine {
  int number = 0;
  std::string refusal;  ///< empty for ACK
};

struct JointPosition {
  double deg = 0.0;
  double age_s = 0.0;  ///< when the robot said it
};

struct PositionsLine {
  std::optional<JointPosition> pan;
  std::optional<JointPosition> tilt;
  std::string state;  ///< START, HOLD, MOVE, LOST, FAULT
};

struct StatusLine {
  std::string axis;  ///< PAN or TILT
  std::string rest;
};

/// Positions of a robot that speaks in bare angles.
struct BarePositionsLine {
  PanTilt joints;
};

using RobotLine = std::variant<ReadyLine, AnswerLine, PositionsLine, StatusLine, BarePositionsLine>;

/// Takes what docs/protocol.md allows and nothing else: limits beyond those of RobotLimits, angles that are
/// no numbers or beyond 180 degrees, and ages of more than 250 ms make a line no line of a robot.
/// @param line without its end
/// @return what it says; empty where it is damaged, or no line of a robot
[[nodiscard]] std::optional<RobotLine> parse_robot_line(std::string_view line);

}  // namespace rva
