#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "cli/camera_uri.hpp"
#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/robot_uri.hpp"
#include "cli/terminal_progress.hpp"
#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/file_origin.hpp"
#include "core/json_object.hpp"
#include "doctor/camera_checkup.hpp"
#include "doctor/computer_checkup.hpp"
#include "doctor/robot_checkup.hpp"

namespace rva::cli {
namespace {

struct DoctorArguments {
  std::string camera = "realsense";
  std::string robot = "none";
  std::string data = ".";
  std::uint64_t seed = 1;
  bool move = false;
  bool json = false;
  DoctorOptions options;
  RealSenseOptions realsense;
};

std::string port_of(const std::string& robot) {
  constexpr std::string_view scheme = "serial:";
  return robot.starts_with(scheme) ? robot.substr(scheme.size()) : "";
}

CheckedItems camera_items(const DoctorArguments& arguments) {
  if (arguments.camera == "none") return none_tried(camera_check_names(), "no camera was named");
  const bool device = is_device(arguments.camera);
  CameraNeeds needs{arguments.options, std::nullopt, device};
  if (device) needs.rate_hz = arguments.realsense.rate_hz;
  return examine_camera(
      [&] { return open_camera(arguments.camera, arguments.seed, {}, arguments.realsense); }, needs,
      terminal_progress());
}

CheckedItems robot_items(const DoctorArguments& arguments) {
  if (arguments.robot == "none")
    return none_tried(robot_check_names(), "no robot was named: give --robot serial:DEVICE");
  return examine_robot(
      [&]() -> OpenedRobot {
        if (port_of(arguments.robot).empty())
          return {open_robot(arguments.robot, steady_clock(), arguments.seed).robot, nullptr};
        std::unique_ptr<SerialRobot> robot = open_serial_robot(arguments.robot);
        SerialRobot* const serial = robot.get();
        return {std::move(robot), serial};
      },
      arguments.move);
}

void print_part(const char* part, const CheckedItems& items) {
  print("{}\n", part);
  for (const CheckedItem& item : items) {
    print("  {:<9}  {:<15}  {}\n", name_of(item.state), item.name, item.result);
    if (!item.advice.empty()) print("  {:<9}  {:<15}  do this: {}\n", "", "", item.advice);
  }
}

void print_checkup(const Checkup& checkup) {
  print_part("computer", checkup.computer);
  print_part("camera", checkup.camera);
  print_part("robot", checkup.robot);
  const CheckState state = worst(checkup);
  if (state == CheckState::failed)
    print("not fit: begin with the first check that failed, since later ones may follow from it\n");
  else
    print("{}\n", state == CheckState::warning ? "fit, with warnings" : "fit");
}

void print_json(const DoctorArguments& arguments, const Checkup& checkup) {
  print("{}", json_file_text({{"format", "rva-doctor"},
                              {"version", 1},
                              {"provenance", provenance_json(iso_8601_now())},
                              {"camera", arguments.camera},
                              {"robot", arguments.robot},
                              {"state", name_of(worst(checkup))},
                              {"checks", json_of(checkup)}}));
}

void examine(const DoctorArguments& arguments, Outcome& outcome) {
  check_options(arguments.options);
  check_options(arguments.realsense);
  Checkup checkup;
  checkup.computer = examine_computer({is_device(arguments.camera), port_of(arguments.robot), arguments.data,
                                       arguments.options.least_free_gb});
  checkup.camera = camera_items(arguments);
  checkup.robot = robot_items(arguments);
  if (arguments.json)
    print_json(arguments, checkup);
  else
    print_checkup(checkup);
  if (worst(checkup) == CheckState::failed) outcome.status = status_detected;
}

}  // namespace

void add_doctor_command(CLI::App& program, Outcome& outcome) {
  CLI::App& command = *program.add_subcommand(
      "doctor", "checks computer, camera and robot in the order in which they fail, and states what to do");
  const auto arguments = std::make_shared<DoctorArguments>();
  command.add_option("--camera", arguments->camera, "realsense[:SERIAL], sim:SCENE, replay:PATH, or none")
      ->type_name("URI")
      ->capture_default_str();
  command.add_option("--robot", arguments->robot, "serial:DEVICE, sim, or none")
      ->type_name("URI")
      ->capture_default_str();
  command.add_option("--data", arguments->data, "folder in which captures will be kept")
      ->type_name("DIR")
      ->capture_default_str();
  command.add_flag("--move", arguments->move,
                   "turns the robot by up to 20 degrees and back, to measure how soon it stops");
  command
      .add_option("--seed", arguments->seed,
                  "seed of a simulated camera's noise and a simulated robot's errors")
      ->check(any_seed())
      ->capture_default_str();
  command.add_flag("--json", arguments->json, "print JSON instead of text");
  add_flags(command, arguments->options);
  add_flags(command, arguments->realsense);
  command.callback([arguments, &outcome] { examine(*arguments, outcome); });
}

}  // namespace rva::cli
