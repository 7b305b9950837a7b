// What every robot does, whether it is a device or a simulation.
#pragma once

#include "core/clock.hpp"
#include "geometry/pan_tilt.hpp"
#include "robot/robot_limits.hpp"

namespace rva {

/// Two joints that carry the camera. Every member may be called from any thread, so that one can stop what
/// another has started. Angles are as geometry/pan_tilt.hpp defines them.
class Robot {
 public:
  Robot() = default;
  virtual ~Robot() = default;
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  [[nodiscard]] virtual RobotLimits limits() const = 0;

  /// Starts towards the target and returns; a target that is still under way is given up for it.
  /// @throws UsageError when the target is beyond limits(), Error when the robot does not take the command;
  ///         nothing moves then that did not before
  virtual void move_to(const PanTilt& target) = 0;

  /// Where the servos say they are: in their steps, blind to play behind them.
  /// @throws Error when they do not answer; never an angle that was not measured
  [[nodiscard]] virtual PanTilt joints() = 0;

  /// From the return of move_to() until the target is reached or given up. @throws Error as joints()
  [[nodiscard]] virtual bool moving() = 0;

  /// Gives up the target and holds the joints where they are. @throws Error when the robot cannot be reached
  virtual void stop() = 0;
};

/// A robot that rests has arrived when its joints() are this close to the target: more than a servo's step,
/// less than a push.
inline constexpr double arrival_tolerance_deg = 1.0;

/// Moves and waits until the robot rests there. An interrupt, and a robot that takes too long, stop it.
/// @return joints() at rest
/// @throws UsageError, Error  as Robot; Error when it rests elsewhere or takes more than `limit_s`
/// @throws Interrupted        when a person stopped the program meanwhile
PanTilt move_and_wait(Robot& robot, const PanTilt& target, const Clock& clock = steady_clock(),
                      double limit_s = 30.0);

}  // namespace rva
