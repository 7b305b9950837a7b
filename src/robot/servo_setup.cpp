#include "robot/servo_setup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "core/error.hpp"

namespace rva {
namespace {

// The firmware starts the servo anew after 100 ms, and the servo needs some time for that.
constexpr std::chrono::milliseconds starts_within{500};

int only_servo(SerialRobot& robot, ServoJoint joint) {
  const std::vector<int> found = robot.find_servos();
  const std::string alone = fmt::format("connect the {} servo alone", name_of(joint));
  if (found.empty()) throw Error("robot", "no servo answers", alone + ", and check its 12 V");
  if (found.size() > 1)
    throw Error("robot", fmt::format("several servos answer (IDs {})", fmt::join(found, ", ")), alone);
  return found.front();
}

}  // namespace

std::string_view name_of(ServoJoint joint) { return joint == ServoJoint::pan ? "pan" : "tilt"; }

int set_up_servo(SerialRobot& robot, ServoJoint joint) {
  const int before = only_servo(robot, joint);
  const int id = static_cast<int>(joint);
  if (before == id) return before;
  robot.name_servo(before, id);
  std::this_thread::sleep_for(starts_within);
  if (robot.find_servos() != std::vector{id})
    throw Error("robot", fmt::format("the servo with ID {} did not take the ID {}", before, id),
                "switch its 12 V off and on, and try again");
  return before;
}

}  // namespace rva
