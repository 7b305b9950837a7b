// The host's side of docs/protocol.md: composes frames to the robot and parses its lines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/pan_tilt.hpp"
#include "robot/lamp.hpp"
#include "robot/robot_limits.hpp"

namespace rva {

/// A frame with its number, its checksum and a line end.
/// @param number 0 to 255
/// @param body   a verb and its arguments
[[nodiscard]] std::string robot_frame(int number, std::string_view body);

/// The body of MOVE: angles in degrees with two decimals.
[[nodiscard]] std::string move_body(const PanTilt& target);

/// The body of LAMP. @param percent 0 to 100
[[nodiscard]] std::string lamp_body(int percent);

/// The body of NAME. @param from, to 0 to greatest_servo_id
[[nodiscard]] std::string name_body(int from, int to);

/// The body of MIDDLE. @param id 0 to greatest_servo_id
[[nodiscard]] std::string middle_body(int id);

/// IDs of servos are 0 to this one.
inline constexpr int greatest_servo_id = 253;

/// The line with which the robot states its protocol and limits.
struct ReadyLine {
  int protocol = 0;      ///< version of the protocol
  std::string firmware;  ///< version of the firmware
  RobotLimits limits;    ///< range of the joints
};

/// ACK, or NAK with a reason.
struct AnswerLine {
  int number = 0;       ///< number of the frame that it answers
  std::string refusal;  ///< empty for ACK
};

/// A joint's angle as the robot measured it.
struct JointPosition {
  double deg = 0.0;    ///< angle
  double age_s = 0.0;  ///< time since the measurement, when the robot sent it
};

/// The robot's report of its joints. A joint is empty where its servo gave no position.
struct PositionsLine {
  std::optional<JointPosition> pan;   ///< empty if there is no measurement of at most 250 ms
  std::optional<JointPosition> tilt;  ///< likewise
  std::string state;                  ///< START, HOLD, MOVE, LOST, FAULT
};

/// The state of one axis: the name of the axis and the rest of the line.
struct StatusLine {
  std::string axis;  ///< PAN or TILT
  std::string rest;  ///< the remaining words: error, detail, volts, heat
};

/// The lamp, if the robot has one.
struct LampLine {
  std::optional<LampState> lamp;  ///< empty if there is no thermistor, so that the lamp cannot be used
};

/// The servos that answered.
struct FoundLine {
  std::vector<int> ids;  ///< rising, 0 to 253, eight at most
};

/// Positions of a robot with the thesis' firmware, which sends bare angles.
struct BarePositionsLine {
  PanTilt joints;  ///< as the robot sends them
};

/// A line from the robot that was understood.
using RobotLine =
    std::variant<ReadyLine, AnswerLine, PositionsLine, StatusLine, LampLine, FoundLine, BarePositionsLine>;

/// Parses a line, strictly as docs/protocol.md defines it. Lines are rejected if they state limits beyond
/// those of RobotLimits, angles that are not numbers or exceed 180 degrees, or ages of more than 250 ms.
/// @param line without its line end
/// @return the contents; empty if the line is damaged or not one of a robot
[[nodiscard]] std::optional<RobotLine> parse_robot_line(std::string_view line);

}  // namespace rva
