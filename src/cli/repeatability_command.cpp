#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/repeatability_printing.hpp"
#include "cli/rig_uri.hpp"
#include "cli/terminal_progress.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/replaceable_file.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "map/repeatability.hpp"
#include "map/repeatability_summary.hpp"
#include "map/waypoints.hpp"

namespace rva::cli {
namespace {

struct RepeatabilityArguments {
  std::string camera;
  std::string robot;
  std::optional<std::string> waypoints;
  std::optional<std::string> geometry;
  std::optional<std::string> out;
  RepeatabilityOptions options;
  RepeatabilityLimits limits;
  RealSenseOptions realsense;
  std::uint64_t seed = 1;
  bool overwrite = false;
  bool json = false;
};

// Both joints at three angles: over the range in which a bay is inspected.
std::vector<PanTilt> poses_of(const RepeatabilityArguments& arguments) {
  if (arguments.waypoints) return load_waypoints(*arguments.waypoints);
  return {{-30.0, -35.0}, {0.0, -20.0}, {30.0, -5.0}};
}

void measure_returns(const RepeatabilityArguments& arguments, Outcome& outcome) {
  check_options(arguments.options);
  check_options(arguments.limits);
  if (arguments.out) require_replaceable(*arguments.out, arguments.overwrite);
  const std::vector<PanTilt> poses = poses_of(arguments);
  const PanTiltChain chain = arguments.geometry ? load_robot_geometry(*arguments.geometry) : PanTiltChain{};
  const OpenRig rig = open_rig(arguments.camera, arguments.robot, arguments.seed, arguments.realsense);
  const Repeatability measured = measure_repeatability({*rig.camera, *rig.robot, rig.clock, chain, {}}, poses,
                                                       arguments.options, terminal_progress());
  const RepeatabilitySummary summary = summary_of(measured, arguments.limits);
  const std::string text = json_file_text(json_of(measured, summary));
  if (arguments.out) replace_file(*arguments.out, text);
  if (arguments.json)
    print("{}", text);
  else
    print_summary(measured, summary);
  if (summary.verdict != Fitness::fit) outcome.status = status_detected;
}

}  // namespace

void add_repeatability_command(CLI::App& robot, Outcome& outcome) {
  CLI::App& command = *robot.add_subcommand(
      "repeatability", "measures with the camera how well the robot comes back to a pose");
  const auto arguments = std::make_shared<RepeatabilityArguments>();
  command.add_option("--camera", arguments->camera, "sim:SCENE or realsense[:SERIAL]")
      ->required()
      ->type_name("URI");
  command.add_option("--robot", arguments->robot, "sim or serial:DEVICE")->required()->type_name("URI");
  command
      .add_option("--waypoints", arguments->waypoints,
                  "poses to come back to; by default pan -30, tilt -35; pan 0, tilt -20; pan 30, tilt -5")
      ->type_name("FILE");
  command.add_option("--geometry", arguments->geometry, "geometry of the robot, as rva calibrate writes it")
      ->type_name("FILE");
  command.add_option("--out", arguments->out, "the result with every return, as JSON")->type_name("FILE");
  command.add_option("--seed", arguments->seed, "of a simulation's noise")
      ->check(any_seed())
      ->capture_default_str();
  add_flags(command, arguments->options);
  add_flags(command, arguments->limits);
  add_flags(command, arguments->realsense);
  command.add_flag("--overwrite", arguments->overwrite, "replace FILE");
  command.add_flag("--json", arguments->json, "print JSON");
  command.callback([arguments, &outcome] { measure_returns(*arguments, outcome); });
}

}  // namespace rva::cli
