#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/printing.hpp"
#include "cli/robot_uri.hpp"
#include "core/error.hpp"
#include "robot/servo_setup.hpp"

namespace rva::cli {
namespace {

struct RobotSetupArguments {
  std::string robot;
  std::optional<std::string> joint;
  bool middle = false;
};

std::string described(int id) {
  if (id == static_cast<int>(ServoJoint::pan)) return "1 (pan)";
  if (id == static_cast<int>(ServoJoint::tilt)) return "2 (tilt)";
  return fmt::format("{} (no joint)", id);
}

void name_servo(SerialRobot& robot, ServoJoint joint, bool middle) {
  const int id = static_cast<int>(joint);
  const int before = set_up_servo(robot, joint);
  if (before == id)
    print("the {} servo has the ID {} already\n", name_of(joint), id);
  else
    print("the servo with the ID {} is now the {} servo, with the ID {}\n", before, name_of(joint), id);
  if (!middle) return;
  robot.turn_to_middle(id);
  print("it turns to its middle, which takes three seconds\n");
}

// Status 3: something is missing before the robot can be used.
void list_parts(SerialRobot& robot, Outcome& outcome) {
  print("firmware: {}\n", robot.firmware());
  const std::vector<int> found = robot.find_servos();
  for (const int id : found) print("servo: {}\n", described(id));
  for (const ServoJoint joint : {ServoJoint::pan, ServoJoint::tilt}) {
    if (std::ranges::find(found, static_cast<int>(joint)) != found.end()) continue;
    print("missing: the {} servo; connect it alone, then: rva robot setup --joint {}\n", name_of(joint),
          name_of(joint));
    outcome.status = status_detected;
  }
  const std::optional<LampState> lamp = robot.lamp();
  if (lamp && lamp->celsius)
    print("lamp: {:.1f} degrees Celsius\n", *lamp->celsius);
  else
    print("lamp: none, or its thermistor is not connected\n");
}

void set_up_robot(const RobotSetupArguments& arguments, Outcome& outcome) {
  const std::unique_ptr<SerialRobot> robot = open_serial_robot(arguments.robot);
  if (arguments.joint)
    name_servo(*robot, *arguments.joint == "pan" ? ServoJoint::pan : ServoJoint::tilt, arguments.middle);
  else
    list_parts(*robot, outcome);
}

}  // namespace

void add_robot_setup_command(CLI::App& robot, Outcome& outcome) {
  CLI::App& command =
      *robot.add_subcommand("setup", "lists what is connected to the robot's board, or names a servo");
  const auto arguments = std::make_shared<RobotSetupArguments>();
  command.add_option("--robot", arguments->robot, "serial:DEVICE")->required()->type_name("URI");
  command
      .add_option("--joint", arguments->joint,
                  "pan or tilt: gives the only servo that is connected the ID of this joint, for good")
      ->check(CLI::IsMember({"pan", "tilt"}));
  command
      .add_flag("--middle", arguments->middle,
                "then turns this servo to its middle, before its horn is screwed to a part")
      ->needs("--joint");
  command.callback([arguments, &outcome] { set_up_robot(*arguments, outcome); });
}

}  // namespace rva::cli
