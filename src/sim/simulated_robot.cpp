#include "sim/simulated_robot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rva {

SimulatedRobot::SimulatedRobot(const SimulatedRobotOptions& options, std::function<double()> now_s,
                               std::uint64_t seed)
    : options_(options), now_s_(std::move(now_s)), random_(seed), advanced_s_(now_s_()) {
  check_options(options_);
}

// The servo pushes the camera up from below, and down from above once the play is used up. Between two
// commands it turns in one direction only, so intermediate positions need not be computed.
void SimulatedRobot::Axis::advance(double travel_deg, double backlash_deg) {
  servo_deg = std::clamp(target_deg, servo_deg - travel_deg, servo_deg + travel_deg);
  camera_deg = std::clamp(camera_deg, servo_deg, servo_deg + backlash_deg);
}

void SimulatedRobot::advance_to_now() {
  const double now_s = now_s_();
  const double travel_deg = std::max(0.0, now_s - advanced_s_) * options_.speed_deg_s;
  pan_.advance(travel_deg, options_.backlash_deg);
  tilt_.advance(travel_deg, options_.backlash_deg);
  advanced_s_ = std::max(advanced_s_, now_s);
}

double SimulatedRobot::nearest_step_deg(double angle_deg, const AxisLimits& limits) const {
  const double step_deg = options_.resolution_deg;
  if (step_deg == 0.0) return angle_deg;
  const double nearest_deg = std::round(angle_deg / step_deg) * step_deg;
  if (nearest_deg > limits.max_deg) return nearest_deg - step_deg;
  if (nearest_deg < limits.min_deg) return nearest_deg + step_deg;
  return nearest_deg;
}

double SimulatedRobot::resting_angle_deg(double angle_deg, const AxisLimits& limits) {
  const double step_deg = nearest_step_deg(angle_deg, limits);
  const double error_deg = options_.rest_error_deg;
  return error_deg == 0.0
             ? step_deg
             : std::clamp(step_deg + random_.uniform(-error_deg, error_deg), limits.min_deg, limits.max_deg);
}

void SimulatedRobot::move_to(const PanTilt& target) {
  limits().check(target);
  const std::lock_guard lock(mutex_);
  advance_to_now();
  pan_.target_deg = resting_angle_deg(target.pan_deg, limits().pan);
  tilt_.target_deg = resting_angle_deg(target.tilt_deg, limits().tilt);
}

void SimulatedRobot::stop() {
  const std::lock_guard lock(mutex_);
  advance_to_now();
  pan_.target_deg = pan_.servo_deg;
  tilt_.target_deg = tilt_.servo_deg;
}

PanTilt SimulatedRobot::joints() {
  const std::lock_guard lock(mutex_);
  advance_to_now();
  return {nearest_step_deg(pan_.servo_deg, limits().pan), nearest_step_deg(tilt_.servo_deg, limits().tilt)};
}

bool SimulatedRobot::moving() {
  const std::lock_guard lock(mutex_);
  advance_to_now();
  return pan_.servo_deg != pan_.target_deg || tilt_.servo_deg != tilt_.target_deg;
}

std::optional<LampState> SimulatedRobot::lamp() {
  const std::lock_guard lock(mutex_);
  return LampState{.percent = lamp_percent_};
}

void SimulatedRobot::set_lamp(int percent) {
  check_lamp_percent(percent);
  const std::lock_guard lock(mutex_);
  lamp_percent_ = percent;
}

PanTilt SimulatedRobot::true_joints() {
  const std::lock_guard lock(mutex_);
  advance_to_now();
  return {pan_.camera_deg, tilt_.camera_deg};
}

}  // namespace rva
