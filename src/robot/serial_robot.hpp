// A robot on a serial port (docs/protocol.md), with RVA's firmware or the thesis'.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/robot.hpp"

namespace rva {

/// The kind of firmware that was recognised.
enum class RobotKind {
  unknown,  ///< disconnected, or not recognised yet
  framed,   ///< RVA's: answers commands, and holds when the host stops sending
  bare,     ///< the thesis': takes whole degrees, and does not answer
};

/// Separate threads read the port and keep the connection alive. When the device is disconnected, calls throw
/// Error until it is back; it is then reopened automatically.
class SerialRobot : public Robot {
 public:
  /// Opens the device, which resets the board, and waits up to five seconds until the robot is recognised: a
  /// boot loader takes a second or two. It then waits up to one second until the robot has found its servos.
  /// @throws Error as SerialLink; when the device is not a robot, or sends nothing; Interrupted
  explicit SerialRobot(const std::string& device);
  ~SerialRobot() override;

  /// The firmware of the connected robot.
  [[nodiscard]] RobotKind kind() const;
  /// The version of the firmware; empty for a bare one.
  [[nodiscard]] std::string firmware() const;

  /// The limits that the robot reported, else those of the thesis' robot.
  [[nodiscard]] RobotLimits limits() const override;

  /// Repeats the command until the robot answers, for up to half a second. A bare robot gets whole degrees,
  /// without an answer.
  void move_to(const PanTilt& target) override;

  /// Angles that were measured at most 250 ms ago. @throws Error when there are none
  [[nodiscard]] PanTilt joints() override;

  /// A bare robot counts as moving while its angles change.
  /// @throws Error as joints(); when a servo is at fault, or the robot stopped because it received nothing
  [[nodiscard]] bool moving() override;

  /// Takes precedence over other commands. A bare robot is sent to its present angles.
  void stop() override;

  /// Stops, and asks every ID for a servo, for up to three seconds. Moves are refused meanwhile.
  /// @return the IDs that answered, rising, eight at most
  /// @throws Error when the robot does not answer, or has firmware that cannot do this
  [[nodiscard]] std::vector<int> find_servos();
  /// Gives a servo another ID for good. The servo starts anew, without torque.
  /// @param from, to 0 to 253
  /// @throws UsageError when an ID is out of range; Error as find_servos()
  void name_servo(int from, int to);
  /// Holds a servo and turns it to its middle within three seconds, without waiting for it. The other one
  /// need not be there, and limits are not checked: for servos that are not mounted yet.
  /// @param id 0 to 253
  /// @throws as name_servo()
  void turn_to_middle(int id);

  /// Firmware before 1.1 reports no lamp, and neither does a bare robot.
  [[nodiscard]] std::optional<LampState> lamp() override;
  /// Repeats the command as move_to().
  void set_lamp(int percent) override;

 private:
  class Conversation;
  std::unique_ptr<Conversation> conversation_;
};

}  // namespace rva
