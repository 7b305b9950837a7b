#include "doctor/robot_checkup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/path_text.hpp"
#include "doctor/version.hpp"
#include "robot/dither.hpp"
#include "robot/servo_setup.hpp"

namespace rva {
namespace {

constexpr double poll_s = 0.01;

// Calls the function until it returns something or the time is over, and returns what it returned last.
template <typename Result>
Result within(const Clock& clock, double limit_s, const std::function<Result()>& ask) {
  const double end_s = clock.now_s() + limit_s;
  Result result = ask();
  while (!result && clock.now_s() < end_s) {
    wait_until(clock, clock.now_s() + poll_s);
    result = ask();
  }
  return result;
}

// Servos were just asked for, or the board has just started: their angles are unknown for a moment.
PanTilt joints_soon(Robot& robot, const Clock& clock) {
  constexpr double limit_s = 2.0;
  const auto joints = within<std::optional<PanTilt>>(clock, limit_s, [&]() -> std::optional<PanTilt> {
    try {
      return robot.joints();
    } catch (const Error&) {
      return std::nullopt;
    }
  });
  return joints ? *joints : robot.joints();
}

void require_both_servos(SerialRobot& robot) {
  const std::vector<int> found = robot.find_servos();
  for (const ServoJoint joint : {ServoJoint::pan, ServoJoint::tilt}) {
    if (std::ranges::find(found, static_cast<int>(joint)) != found.end()) continue;
    throw Error(
        fmt::format("servo {}", static_cast<int>(joint)),
        fmt::format("the {} servo does not answer{}", name_of(joint),
                    found.empty() ? "" : fmt::format(" (those with the IDs {} do)", fmt::join(found, ", "))),
        "check its 12 V, the emergency stop and its cable; a new servo is given its ID by rva robot "
        "setup --joint " +
            std::string(name_of(joint)));
  }
}

CheckedItem servos_item(const OpenedRobot& opened, const Clock& clock) {
  constexpr const char* name = "servos";
  try {
    if (opened.serial != nullptr && opened.serial->kind() == RobotKind::framed)
      require_both_servos(*opened.serial);
    const PanTilt joints = joints_soon(*opened.robot, clock);
    static_cast<void>(opened.robot->moving());  // throws if a servo is at fault
    CheckedItem item = passed(
        name, fmt::format("both answer: pan {:.1f}, tilt {:.1f} degrees", joints.pan_deg, joints.tilt_deg));
    item.values = {{"pan_deg", joints.pan_deg}, {"tilt_deg", joints.tilt_deg}};
    return item;
  } catch (const Error& error) {
    return failed(name, error);
  }
}

/// How a robot in motion came to rest.
struct Stop {
  double duration_s = 0.0;  // from the command to the last change of an angle
  double overshoot_deg = 0.0;
};

double distance_deg(const PanTilt& a, const PanTilt& b) {
  return std::max(std::abs(a.pan_deg - b.pan_deg), std::abs(a.tilt_deg - b.tilt_deg));
}

void begin_turn(Robot& robot, const PanTilt& start, const Clock& clock) {
  constexpr double turn_deg = 20.0;
  constexpr double under_way_deg = 3.0;
  constexpr double limit_s = 2.0;
  robot.move_to({start.pan_deg + (start.pan_deg > 0.0 ? -turn_deg : turn_deg), start.tilt_deg});
  const bool turns =
      within<bool>(clock, limit_s, [&] { return distance_deg(robot.joints(), start) > under_way_deg; });
  if (turns) return;
  robot.stop();
  throw Error("robot", "the pan joint does not turn", "remove obstacles, and check the servos' 12 V");
}

Stop stop_and_watch(Robot& robot, const Clock& clock) {
  constexpr double rest_s = 0.3;
  constexpr double limit_s = 2.0;
  const double start_s = clock.now_s();
  const PanTilt before = robot.joints();
  robot.stop();
  PanTilt last = before;
  double changed_s = start_s;
  while (clock.now_s() - changed_s < rest_s && clock.now_s() - start_s < limit_s) {
    wait_until(clock, clock.now_s() + poll_s);
    const PanTilt now = robot.joints();
    if (distance_deg(now, last) < 0.5 * servo_step_deg) continue;
    last = now;
    changed_s = clock.now_s();
  }
  return {changed_s - start_s, distance_deg(last, before)};
}

// After an error, which may also be why it cannot be stopped.
void stop_if_possible(Robot& robot) {
  try {
    robot.stop();
  } catch (const Error&) {
    return;
  }
}

CheckedItem stop_item(Robot& robot, const Clock& clock) {
  constexpr const char* name = "stop";
  constexpr double soon_s = 0.25;
  constexpr double latest_s = 0.5;
  try {
    const PanTilt start = joints_soon(robot, clock);
    begin_turn(robot, start, clock);
    const Stop stop = stop_and_watch(robot, clock);
    move_and_wait(robot, start, clock);
    CheckedItem item = passed(name, fmt::format("rests {:.2f} s after the command, {:.1f} degrees farther",
                                                stop.duration_s, stop.overshoot_deg));
    item.values = {{"stop_s", stop.duration_s}, {"overshoot_deg", stop.overshoot_deg}};
    if (stop.duration_s <= soon_s) return item;
    item.state = stop.duration_s > latest_s ? CheckState::failed : CheckState::warning;
    item.advice = "do not drive it beside people; check its power, the load on the joints and the USB cable";
    return item;
  } catch (const Error& error) {
    stop_if_possible(robot);
    return failed(name, error);
  } catch (const Interrupted&) {
    stop_if_possible(robot);
    throw;
  }
}

// Lights it dimly for a moment.
void try_lamp(Robot& robot, const LampState& before, const Clock& clock) {
  constexpr int dim_percent = 20;
  constexpr double limit_s = 2.0;
  robot.set_lamp(dim_percent);
  const bool lit =
      within<bool>(clock, limit_s, [&] { return robot.lamp().value_or(LampState{}).percent == dim_percent; });
  robot.set_lamp(before.percent);
  if (!lit) throw Error("lamp", "it does not report the brightness that it was given", "try again");
}

CheckedItem lamp_item(Robot& robot, const Clock& clock) {
  constexpr const char* name = "lamp";
  constexpr double limit_s = 2.0;
  try {
    const auto lamp = within<std::optional<LampState>>(clock, limit_s, [&] { return robot.lamp(); });
    if (!lamp)
      return {name,
              CheckState::warning,
              "the robot reports no lamp",
              "if it has one, check the cable of its thermistor, and load the firmware of this version",
              {}};
    CheckedItem item = passed(name, lamp->celsius ? fmt::format("{:.1f} degrees Celsius", *lamp->celsius)
                                                  : "its temperature is not measured");
    if (lamp->celsius) item.values = {{"celsius", *lamp->celsius}};
    if (lamp->too_hot) {
      item.state = CheckState::failed;
      item.result += ": it was switched off, since it is too hot";
      item.advice = "let it cool down, and check that air reaches its frame";
      return item;
    }
    try_lamp(robot, *lamp, clock);
    item.result = "can be switched, " + item.result;
    return item;
  } catch (const Error& error) {
    return failed(name, error);
  }
}

CheckedItem robot_item(const OpenedRobot& opened) {
  if (opened.serial == nullptr) return passed("robot", "a simulated robot");
  return passed("robot", opened.serial->kind() == RobotKind::bare ? "answers as the thesis' robot"
                                                                  : "answers as a robot of RVA");
}

CheckedItems items_of(const OpenedRobot& opened, bool may_move, const Clock& clock) {
  CheckedItems items{robot_item(opened),
                     opened.serial == nullptr
                         ? not_tried("robot-firmware", "a simulated robot has none")
                         : robot_firmware_item(opened.serial->kind(), opened.serial->firmware())};
  items.push_back(servos_item(opened, clock));
  if (items.back().state == CheckState::failed)
    items.push_back(not_tried("stop", "the servos do not answer"));
  else if (!may_move)
    items.push_back(not_tried("stop", "it turns the robot: give --move, with a hand at the emergency stop"));
  else
    items.push_back(stop_item(*opened.robot, clock));
  items.push_back(lamp_item(*opened.robot, clock));
  return items;
}

}  // namespace

std::vector<std::string> robot_check_names() { return {"robot", "robot-firmware", "servos", "stop", "lamp"}; }

CheckedItem robot_firmware_item(RobotKind kind, const std::string& version) {
  constexpr const char* name = "robot-firmware";
  constexpr std::string_view least = "1.1.0";  // the first with a lamp, and with commands for servo IDs
  constexpr const char* advice = "load the firmware of this version of rva (firmware/README.md)";
  if (kind == RobotKind::bare)
    return {name,
            CheckState::warning,
            "the thesis' firmware, which neither answers nor stops when the computer falls silent",
            advice,
            {}};
  const auto numbers = version_numbers(version);
  if (numbers && *numbers >= version_numbers(least)) return passed(name, printable(version));
  return {
      name, CheckState::warning, fmt::format("{} is older than {}", printable(version), least), advice, {}};
}

CheckedItems examine_robot(const OpensRobot& open, bool may_move, const Clock& clock) {
  try {
    return items_of(open(), may_move, clock);
  } catch (const UsageError&) {  // a URI of another form: no device was tried
    throw;
  } catch (const Error& error) {
    CheckedItems items = none_tried(robot_check_names(), "the robot could not be opened");
    items.front() = failed("robot", error);
    return items;
  }
}

}  // namespace rva
