// The thesis' robot without the robot: two servos with steps and play.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>

#include "core/options.hpp"
#include "core/random.hpp"
#include "robot/dither.hpp"
#include "robot/robot.hpp"

namespace rva {

struct SimulatedRobotOptions {
  double speed_deg_s = 90.0;
  double backlash_deg = 0.3;
  double resolution_deg = servo_step_deg;
  double rest_error_deg = 0.0;

  static void describe(auto&& self, auto&& visit) {
    visit(self.speed_deg_s, OptionField{"speed", "deg_s", 0.1, 1000, "how fast either joint turns"});
    visit(self.backlash_deg, OptionField{"backlash", "deg", 0, 5, "play between a servo and what it turns"});
    visit(self.resolution_deg,
          OptionField{"resolution", "deg", 0, 1,
                      "a servo's step; targets and feedback are whole steps, 0 for any angle"});
    visit(self.rest_error_deg,
          OptionField{"rest-error", "deg", 0, 0.16,
                      "how far from its step a servo may come to rest, unseen by itself"});
  }
};

/// Starts at rest at 0, 0 and follows commands at constant speed, each joint by itself: nothing is gained by
/// ramps where only the poses at rest are used.
///
/// Targets are rounded to whole steps of the servo (Herkulex DRS-0101: 0.325 deg), towards 0 where the
/// nearest lies beyond the limits. Behind each servo there is play: turning up (to larger angles) carries
/// the camera along exactly, turning down leaves it `backlash_deg` behind, and turning back moves nothing
/// until the play is used up. A joint that always arrives from below therefore has no error but
/// rest_error_deg, which is another one, evenly spread, after every command.
///
/// Safe for several threads if `now_s` is.
class SimulatedRobot : public Robot {
 public:
  /// @param now_s seconds that do not go back; motion is computed from it when somebody asks, nothing runs
  ///              in the background
  /// @param seed  of rest errors
  /// @throws UsageError when an option is out of range
  explicit SimulatedRobot(const SimulatedRobotOptions& options = {},
                          std::function<double()> now_s = steady_clock().now_s, std::uint64_t seed = 1);

  [[nodiscard]] RobotLimits limits() const override { return {}; }
  void move_to(const PanTilt& target) override;
  [[nodiscard]] PanTilt joints() override;
  [[nodiscard]] bool moving() override;
  void stop() override;

  /// Where the camera is in truth, play included; no robot can report it.
  [[nodiscard]] PanTilt true_joints();

 private:
  struct Axis {
    double servo_deg = 0.0;
    double target_deg = 0.0;
    double camera_deg = 0.0;

    void advance(double travel_deg, double backlash_deg);
  };

  void advance_to_now();
  [[nodiscard]] double nearest_step_deg(double angle_deg, const AxisLimits& limits) const;
  [[nodiscard]] double resting_place_deg(double angle_deg, const AxisLimits& limits);

  SimulatedRobotOptions options_;
  std::function<double()> now_s_;
  mutable std::mutex mutex_;  // guards all below
  Random random_;
  double advanced_s_ = 0.0;
  Axis pan_;
  Axis tilt_;
};

}  // namespace rva
