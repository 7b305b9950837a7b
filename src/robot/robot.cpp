#include "robot/robot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/interrupt.hpp"

namespace rva {
namespace {

std::string text_of(const PanTilt& joints) {
  return fmt::format("pan {:.1f} tilt {:.1f} deg", joints.pan_deg, joints.tilt_deg);
}

bool is_near(double a_deg, double b_deg) {
  return std::abs(a_deg - b_deg) <= arrival_tolerance_deg;  // false for NaN
}

Error not_arrived(const PanTilt& joints, const PanTilt& target, const std::string& how) {
  return {"robot", fmt::format("{} at {} on its way to {}", how, text_of(joints), text_of(target)),
          "remove obstacles, check its power, and move it again"};
}

void wait_for_rest(Robot& robot, const PanTilt& target, const Clock& clock, double limit_s) {
  constexpr double poll_s = 0.01;
  const double end_s = clock.now_s() + limit_s;
  while (robot.moving()) {
    if (clock.now_s() >= end_s) {
      robot.stop();
      throw not_arrived(robot.joints(), target, fmt::format("still moving after {} s", limit_s));
    }
    wait_until(clock, clock.now_s() + poll_s);
  }
}

}  // namespace

void Robot::set_lamp(int /*percent*/) { throw Error("robot", "has no lamp", "light the bay by other means"); }

PanTilt move_and_wait(Robot& robot, const PanTilt& target, const Clock& clock, double limit_s) {
  robot.move_to(target);
  try {
    wait_for_rest(robot, target, clock, limit_s);
  } catch (const Interrupted&) {
    robot.stop();
    throw;
  }
  const PanTilt joints = robot.joints();
  if (!is_near(joints.pan_deg, target.pan_deg) || !is_near(joints.tilt_deg, target.tilt_deg))
    throw not_arrived(joints, target, "stopped");
  return joints;
}

}  // namespace rva
