// A robot at the end of a serial line (docs/protocol.md), with our firmware or the thesis'.
#pragma once

#include <memory>
#include <string>

#include "robot/robot.hpp"

namespace rva {

/// What the robot at the other end has turned out to be.
enum class RobotKind {
  unknown,  ///< away, or it has not said yet
  framed,   ///< ours: answers, holds when the host falls silent
  bare,     ///< the thesis': whole degrees, nothing is answered
};

/// The line is read and kept alive on a thread of its own; when the device goes away and comes back, so does
/// the robot, and whoever asks meanwhile gets an Error that says so.
class SerialRobot : public Robot {
 public:
  /// Opens the device, which resets the board, and waits for the robot to say what it is: a boot loader
  /// takes a second or two. Another second is left to it to find its servos.
  /// @throws Error as SerialLink; when what is there is no robot, or says nothing; Interrupted
  explicit SerialRobot(const std::string& device);
  ~SerialRobot() override;

  [[nodiscard]] RobotKind kind() const;
  /// Of its firmware; empty of a bare one.
  [[nodiscard]] std::string firmware() const;

  [[nodiscard]] RobotLimits limits() const override;

  /// Says it again until the robot answers, for up to half a second. A bare robot is told whole degrees.
  void move_to(const PanTilt& target) override;

  /// Measured no longer than 250 ms ago.
  [[nodiscard]] PanTilt joints() override;

  /// A bare robot moves as long as its angles do.
  /// @throws Error as joints(); when a servo is at fault, or the robot stopped since it did not hear from us
  [[nodiscard]] bool moving() override;

  /// Overtakes whatever else is said. A bare robot is told to go where it is.
  void stop() override;

 private:
  class Conversation;
  std::unique_ptr<Conversation> conversation_;
};

}  // namespace rva
