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
#include "core/interrupt.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "core/stopwatch.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "map/map_files.hpp"
#include "map/view_capture.hpp"
#include "map/view_folder.hpp"
#include "map/waypoints.hpp"

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
  ViewCaptureOptions capture;
  MapCloudOptions cloud;
  RefinementOptions refinement;
  RealSenseOptions realsense;
  std::uint64_t seed = 1;
  bool no_refine = false;
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

MapView load_view(const fs::path& folder) {
  try {
    return load_map_view(*open_capture(folder), printable(folder));
  } catch (const Error& error) {
    throw Error(error.source(), error.problem(),
                "remove " + printable(folder) + " and resume: it is taken again");
  }
}

// Views get the names that they will have once the map has been moved to its final path.
std::vector<MapView> load_views(const MapFiles& files, const fs::path& taken_in, std::size_t count) {
  const Progress progress = terminal_progress();
  std::vector<MapView> views;
  for (std::size_t i = 0; i < count; ++i) {
    views.push_back(load_view(taken_in / view_name(i)));
    views.back().name = printable(files.views.filename() / view_name(i));
    if (progress) progress("reading", i + 1, count);
  }
  return views;
}

std::vector<RefinedPose> poses_of(const std::vector<MapView>& views, const PanTiltChain& chain,
                                  const MapArguments& arguments) {
  if (!arguments.no_refine) return refine_poses(views, chain, arguments.refinement);
  std::vector<RefinedPose> poses;
  for (const MapView& view : views) {
    poses.emplace_back();
    poses.back().foot_from_camera = foot_from_camera(chain, view.joints);
  }
  return poses;
}

std::vector<Transform> transforms(const std::vector<RefinedPose>& poses) {
  std::vector<Transform> result;
  for (const RefinedPose& pose : poses) result.push_back(pose.foot_from_camera);
  return result;
}

void print_summary(const MapFiles& files, const std::vector<MapView>& views, const MapPoses& map,
                   std::size_t points, double ms, bool as_json) {
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!map.poses[i].doubt.empty())
      fmt::print(stderr, "rva: {}: {}, so its pose is the one given by the joints\n", views[i].name,
                 map.poses[i].doubt);
  }
  if (as_json) {
    nlohmann::ordered_json json = {{"map", printable(files.ply)},
                                   {"views", views.size()},
                                   {"doubted", nlohmann::json::array()},
                                   {"points", points},
                                   {"refined", map.refined},
                                   {"refine_and_join_ms", ms}};
    for (std::size_t i = 0; i < views.size(); ++i) {
      if (!map.poses[i].doubt.empty()) json["doubted"].push_back(views[i].name);
    }
    print("{}\n", json_text(json, 2));
    return;
  }
  print("{}: {} points of {} views\n", printable(files.ply), points, views.size());
}

void check(const MapArguments& arguments) {
  check_map_cloud_options(arguments.cloud);
  check_options(arguments.refinement);
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
  check_waypoints(waypoints, rig.robot->limits());
  ViewFolder folder(files.views, start_of(arguments), waypoints.size());
  const std::string base = base_of(arguments, *rig.camera);
  take_views({*rig.camera, *rig.robot, rig.clock, chain, base}, waypoints, folder.path(), arguments.capture,
             terminal_progress());
  const std::vector<MapView> views = load_views(files, folder.path(), waypoints.size());
  const Stopwatch start;
  const MapPoses map{base,
                     chain,
                     arguments.cloud,
                     !arguments.no_refine,
                     arguments.refinement,
                     poses_of(views, chain, arguments)};
  const std::vector<MapPoint> points = join_views(views, transforms(map.poses), arguments.cloud);
  const double refined_and_joined_ms = start.ms();
  if (points.empty())
    throw Error(printable(files.ply), "would have no point: nothing was measured within --near and --far",
                "check the views in " + printable(folder.path()));
  throw_if_interrupted();
  write_map(files, points, views, map);
  print_summary(files, views, map, points.size(), refined_and_joined_ms, arguments.json);
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
  command.add_option("--frames", arguments->capture.frames, "depth frames of each view")
      ->check(frame_count())
      ->capture_default_str();
  command.add_option("--seed", arguments->seed, "of a simulation's noise")
      ->check(any_seed())
      ->capture_default_str();
  add_flags(command, arguments->cloud);
  add_flags(command, arguments->refinement);
  add_flags(command, arguments->realsense);
  command.add_flag("--no-refine", arguments->no_refine,
                   "keep the poses that the joints give, as the thesis did");
  command.add_flag("--resume", arguments->resume,
                   "go on with a map that was interrupted: take only the missing views");
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier map");
  command.add_flag("--json", arguments->json, "print JSON");
  command.callback([arguments] { map_bay(*arguments); });
}

}  // namespace rva::cli
