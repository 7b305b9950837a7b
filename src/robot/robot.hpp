// The interface of every robot: a device or a simulation.
#pragma once

#include <optional>

#include "core/clock.hpp"
#include "geometry/pan_tilt.hpp"
#include "robot/lamp.hpp"
#include "robot/robot_limits.hpp"

namespace rva {

/// Two joints that carry the camera. Every member may be called from any thread, so that one thread can stop
/// a motion that another has started. geometry/pan_tilt.hpp defines the angles.
class Robot {
 public:
  Robot() = default;
  virtual ~Robot() = default;
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  /// The range of both joints.
  [[nodiscard]] virtual RobotLimits limits() const = 0;

  /// Starts a motion to the target and returns. It replaces an earlier target that has not been reached.
  /// @throws UsageError when the target is beyond limits(), Error when the robot does not take the command;
  ///         no motion has then been started
  virtual void move_to(const PanTilt& target) = 0;

  /// The joint angles that the servos measure, in their steps; they do not include play of the gears. Only
  /// measured angles are returned. @throws Error when the servos do not answer
  [[nodiscard]] virtual PanTilt joints() = 0;

  /// True from the return of move_to() until the target is reached or abandoned. @throws Error as joints()
  [[nodiscard]] virtual bool moving() = 0;

  /// Abandons the target and holds the joints where they are. @throws Error when the robot does not answer
  virtual void stop() = 0;

  /// The lamp around the camera; empty where the robot has none, or does not report it.
  [[nodiscard]] virtual std::optional<LampState> lamp() { return std::nullopt; }

  /// Sets the brightness of the lamp. The robot switches it off when it hears nothing from its host.
  /// @param percent 0 (off) to 100
  /// @throws UsageError when it is out of this range; Error when there is no lamp, when it is too hot, or
  /// when
  ///         the robot does not take the command; the lamp is then unchanged
  virtual void set_lamp(int percent);
};

/// A robot at rest has arrived if its joints() are this close to the target. This is more than a servo's
/// step, and less than the deviation of a robot that has been pushed.
inline constexpr double arrival_tolerance_deg = 1.0;

/// Moves to the target and waits until the robot rests there. Stops the robot on an interrupt or a timeout.
/// @return joints() at rest
/// @throws UsageError, Error  as Robot; Error when it rests elsewhere or takes more than `limit_s`
/// @throws Interrupted        when the user stopped the program meanwhile
PanTilt move_and_wait(Robot& robot, const PanTilt& target, const Clock& clock = steady_clock(),
                      double limit_s = 30.0);

}  // namespace rva
