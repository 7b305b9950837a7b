#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/rig_uri.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "map/bay_map.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct MapArguments {
  std::string camera;
  std::string robot;
  std::optional<std::string> waypoints;
  std::vector<double> grid;
  std::optional<std::string> geometry;
  std::optional<std::string> base;
  std::string out;
  BayMapOptions map;
  RealSenseOptions realsense;
  std::uint64_t seed = 1;
  bool resume = false;
  bool overwrite = false;
  bool json = false;
};

GridAxis grid_axis(const double* from_to_count) {
  const double count = from_to_count[2];
  if (!(count >= 1.0 && count <= most_waypoints && count == std::floor(count)))
    throw UsageError("--grid", fmt::format("{} is not a number of angles", count),
                     "give FROM,TO,COUNT of pan, then of tilt");
  if (count == 1.0 && from_to_count[0] != from_to_count[1])
    throw UsageError("--grid",
                     fmt::format("one angle cannot be both {} and {}", from_to_count[0], from_to_count[1]),
                     "give the same angle twice");
  return {from_to_count[0], from_to_count[1], static_cast<int>(count)};
}

std::vector<PanTilt> waypoints_of(const MapArguments& arguments) {
  if (arguments.waypoints) return load_waypoints(*arguments.waypoints);
  const GridAxis pan = grid_axis(arguments.grid.data());
  const GridAxis tilt = grid_axis(arguments.grid.data() + 3);
  if (pan.count * tilt.count > most_waypoints)
    throw UsageError("--grid", fmt::format("{} waypoints are too many", pan.count * tilt.count),
                     fmt::format("give up to {}", most_waypoints));
  return grid_waypoints(pan, tilt);
}

// Captures of one base share a world frame, so a position for which no name was given gets a unique one.
std::string base_of(const MapArguments& arguments, const Camera& camera) {
  if (arguments.base) return *arguments.base;
  const std::optional<Pose> pose = camera.info().pose;
  if (pose && pose->base) return *pose->base + "-foot";  // a simulated scene's own
  std::random_device device;
  return fmt::format("base-{:08x}", device());
}

ViewFolder::Start start_of(const MapArguments& arguments) {
  if (arguments.resume) return ViewFolder::Start::resume;
  return arguments.overwrite ? ViewFolder::Start::replace : ViewFolder::Start::anew;
}

void print_summary(const MapFiles& files, const BayMap& map, bool as_json) {
  std::vector<std::string> doubted;
  for (std::size_t i = 0; i < map.views.size(); ++i) {
    const std::string& doubt = map.poses.poses[i].doubt;
    if (doubt.empty()) continue;
    doubted.push_back(map.views[i].name);
    fmt::print(stderr, "rva: {}: {}, so its pose is the one given by the joints\n", doubted.back(), doubt);
  }
  if (!as_json) {
    print("{}: {} points of {} views\n", printable(files.ply), map.points, map.views.size());
    return;
  }
  const nlohmann::ordered_json json = {
      {"map", printable(files.ply)},  {"views", map.views.size()},
      {"doubted", doubted},           {"points", map.points},
      {"refined", map.poses.refined}, {"refine_and_join_ms", map.refine_and_join_ms}};
  print("{}\n", json_text(json, 2));
}

void check(const MapArguments& arguments) {
  check_map_cloud_options(arguments.map.cloud);
  check_options(arguments.map.refinement);
  if (arguments.base && (arguments.base->empty() || !is_utf8(*arguments.base)))
    throw UsageError("--base", "is not a name", "give one in UTF-8");
}

void map_bay(const MapArguments& arguments) {
  check(arguments);
  const MapFiles files = map_files(arguments.out);
  const std::vector<PanTilt> waypoints = waypoints_of(arguments);
  const PanTiltChain chain = arguments.geometry ? load_robot_geometry(*arguments.geometry) : PanTiltChain{};
  if (finish_map(files))
    fmt::print(stderr,
               "rva: {}: a map that was being moved here when the program was killed is complete now\n",
               printable(files.ply));
  require_replaceable(files, arguments.overwrite);
  const OpenRig rig = open_rig(arguments.camera, arguments.robot, arguments.seed, arguments.realsense);
  const std::string base = base_of(arguments, *rig.camera);
  try {
    const BayMap map = rva::map_bay({*rig.camera, *rig.robot, rig.clock, chain, base}, waypoints, files,
                                    start_of(arguments), arguments.map, terminal_progress());
    print_summary(files, map, arguments.json);
  } catch (const EmptyMapError& error) {
    throw Error(error.source(), error.problem(), error.remedy() + " with --near and --far");
  }
}

}  // namespace

void add_map_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("map", "drives the waypoints and builds a 3D map of the bay");
  const auto arguments = std::make_shared<MapArguments>();
  command.add_option("--camera", arguments->camera, "sim:SCENE or realsense[:SERIAL]")
      ->required()
      ->type_name("URI");
  command.add_option("--robot", arguments->robot, "sim or serial:DEVICE")->required()->type_name("URI");
  CLI::Option_group& where = *command.add_option_group("waypoints");
  where.add_option("--waypoints", arguments->waypoints, "pan and tilt of each view")->type_name("FILE");
  where.add_option("--grid", arguments->grid, "instead: from, to and count of pan, then of tilt, in degrees")
      ->type_name("FROM,TO,COUNT,FROM,TO,COUNT")
      ->delimiter(',')
      ->expected(6);
  where.require_option(1);
  command
      .add_option("--out", arguments->out, "the map; its .pcd, poses (.json) and captures (.views) beside it")
      ->required()
      ->type_name("FILE.ply");
  command.add_option("--geometry", arguments->geometry, "geometry of the robot, as rva calibrate writes it")
      ->type_name("FILE");
  command.add_option("--base", arguments->base,
                     "name of the position of the robot's foot; captures of one base share a frame");
  command.add_option("--frames", arguments->map.capture.frames, "depth frames of each view")
      ->check(frame_count())
      ->capture_default_str();
  command.add_option("--seed", arguments->seed, "of a simulation's noise")
      ->check(any_seed())
      ->capture_default_str();
  add_flags(command, arguments->map.cloud);
  add_flags(command, arguments->map.refinement);
  add_flags(command, arguments->realsense);
  command.add_flag_callback(
      "--no-refine", [arguments] { arguments->map.refine = false; },
      "keep the poses that the joints give, as the thesis did");
  command.add_flag("--resume", arguments->resume,
                   "go on with a map that was interrupted: take only the missing views");
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier map");
  command.add_flag("--json", arguments->json, "print JSON");
  command.callback([arguments] { map_bay(*arguments); });
}

}  // namespace rva::cli
