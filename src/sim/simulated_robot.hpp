// A simulation of the thesis' robot: two servos with steps and play.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

#include "core/options.hpp"
#include "core/random.hpp"
#include "robot/dither.hpp"
#include "robot/robot.hpp"

namespace rva {

/// Options of the simulated robot.
struct SimulatedRobotOptions {
  double speed_deg_s = 90.0;               ///< how fast either joint turns
  double backlash_deg = 0.3;               ///< play between a servo and what it turns
  double resolution_deg = servo_step_deg;  ///< step of targets and feedback; 0 for any angle
  double rest_error_deg = 0.0;  ///< how far from its step a servo may come to rest, unseen by itself

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

/// Starts at rest at pan 0, tilt 0 and follows commands at constant speed, each joint independently. There
/// are no acceleration ramps, since only the poses at rest are used.
///
/// Targets are rounded to whole steps of the servo (Herkulex DRS-0101: 0.325 deg), towards 0 if the nearest
/// step lies beyond the limits. Behind each servo there is play: turning up (to larger angles) carries the
/// camera along exactly, turning down leaves it `backlash_deg` behind, and turning back does not move it
/// until the play is used up. A joint that always arrives from below therefore has no error except
/// rest_error_deg, which is drawn anew from a uniform distribution after every command.
///
/// Its lamp never gets hot.
///
/// Thread-safe if `now_s` is.
class SimulatedRobot : public Robot {
 public:
  /// @param now_s monotonic clock in seconds; each call computes the motion from it, without a background
  ///              thread
  /// @param seed  seed of the rest errors
  /// @throws UsageError when an option is out of range
  explicit SimulatedRobot(const SimulatedRobotOptions& options = {},
                          std::function<double()> now_s = steady_clock().now_s, std::uint64_t seed = 1);

  [[nodiscard]] RobotLimits limits() const override { return {}; }
  void move_to(const PanTilt& target) override;
  [[nodiscard]] PanTilt joints() override;
  [[nodiscard]] bool moving() override;
  void stop() override;

  [[nodiscard]] std::optional<LampState> lamp() override;
  void set_lamp(int percent) override;

  /// The true angles of the camera, play included, which a real robot cannot report.
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
  [[nodiscard]] double resting_angle_deg(double angle_deg, const AxisLimits& limits);

  SimulatedRobotOptions options_;
  std::function<double()> now_s_;
  mutable std::mutex mutex_;  // guards the members below
  Random random_;
  double advanced_s_ = 0.0;
  Axis pan_;
  Axis tilt_;
  int lamp_percent_ = 0;
};

}  // namespace rva
