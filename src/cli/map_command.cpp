#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>
#include <system_error>
#include <vector>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/rig_uri.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "core/stopwatch.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "map/map_files.hpp"
#include "map/view_capture.hpp"
#include "map/waypoints.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct MapArguments {
  std::string camera;
  std::string robot;
  std::string waypoints;
  std::vector<double> grid;
  std::string geometry;
  std::string base;
  std::string out;
  ViewCaptureOptions capture;
  MapCloudOptions cloud;
  RefinementOptions refinement;
  std::uint64_t seed = 1;
  bool no_refine = false;
  bool resume = false;
  bool overwrite = false;
  bool json = false;
};

std::vector<PanTilt> waypoints_of(const MapArguments& arguments) {
  if (!arguments.waypoints.empty()) return load_waypoints(arguments.waypoints);
  constexpr double most = 100.0;
  const std::vector<double>& grid = arguments.grid;
  for (const double count : {grid[2], grid[5]}) {
    if (!(count >= 1.0 && count <= most && count == static_cast<int>(count)))
      throw UsageError("--grid", fmt::format("{} is no number of angles", count),
                       "give FROM,TO,COUNT of pan, then of tilt");
  }
  return grid_waypoints({grid[0], grid[1], static_cast<int>(grid[2])},
                        {grid[3], grid[4], static_cast<int>(grid[5])});
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

// Captures of one base share a world frame, so a place that nobody named has a name that no other has.
std::string base_of(const MapArguments& arguments, const Camera& camera) {
  if (!arguments.base.empty()) return arguments.base;
  const std::optional<Pose> pose = camera.info().pose;
  if (pose && pose->base) return *pose->base + "-foot";  // a simulated scene's own
  std::random_device device;
  return fmt::format("place-{:08x}", device());
}

// Views, and what is left of one when the program was killed.
bool is_view(const fs::directory_entry& entry) {
  if (!entry.is_directory() || entry.is_symlink()) return false;
  const std::string name = entry.path().filename();
  const std::size_t digits = std::min(name.size(), name.find_first_not_of("0123456789"));
  return digits >= 3 && (digits == name.size() || name.substr(digits).starts_with(".partial-"));
}

void remove_views(const fs::path& views) {
  try {
    if (!fs::is_directory(fs::symlink_status(views)))
      throw Error(printable(views), "is no folder of views, so it is not replaced", "choose another name");
    for (const fs::directory_entry& entry : fs::directory_iterator(views)) {
      if (!is_view(entry))
        throw Error(printable(entry.path()), "is no view, so the folder is not replaced",
                    "move it away or choose another name");
    }
    fs::remove_all(views);
  } catch (const fs::filesystem_error& error) {
    throw Error(printable(views), fmt::format("cannot be replaced ({})", error.code().message()),
                "check its permissions or choose another name");
  }
}

// The folder of captures, ready to be filled.
void make_ready(const MapFiles& files, const MapArguments& arguments) {
  if (!arguments.overwrite && is_there(files.ply))
    throw Error(printable(files.ply), "is there already", "choose another name, or give --overwrite");
  if (!arguments.resume && is_there(files.views)) {
    if (!arguments.overwrite)
      throw Error(printable(files.views), "holds the views of a map",
                  "give --resume to go on with it, --overwrite to begin anew, or another name");
    remove_views(files.views);
  }
  std::error_code failure;
  fs::create_directories(files.views, failure);
  if (failure)
    throw Error(printable(files.views), fmt::format("cannot be made ({})", failure.message()),
                "check the permissions there or choose another place");
}

std::vector<MapView> load_views(const MapFiles& files, std::size_t count) {
  const Progress progress = terminal_progress();
  std::vector<MapView> views;
  for (std::size_t i = 0; i < count; ++i) {
    const fs::path folder = files.views / view_name(i);
    views.push_back(load_map_view(*open_capture(folder), printable(folder)));
    views.back().name = files.views.filename() / view_name(i);
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
                   std::size_t points, double joined_ms, bool as_json) {
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!map.poses[i].doubt.empty())
      fmt::print(stderr, "rva: {}: {}, so its place is the one by the joints\n", views[i].name,
                 map.poses[i].doubt);
  }
  if (as_json) {
    print("{}\n", nlohmann::ordered_json{{"map", files.ply.native()},
                                         {"views", views.size()},
                                         {"points", points},
                                         {"refined", map.refined},
                                         {"join_ms", joined_ms}}
                      .dump(2));
    return;
  }
  print("{}: {} points of {} views\n", printable(files.ply), points, views.size());
}

void map_bay(const MapArguments& arguments) {
  const MapFiles files = map_files(arguments.out);
  const std::vector<PanTilt> waypoints = waypoints_of(arguments);
  const PanTiltChain chain =
      arguments.geometry.empty() ? PanTiltChain{} : load_robot_geometry(arguments.geometry);
  check_options(arguments.cloud);
  check_options(arguments.refinement);
  const OpenRig rig = open_rig(arguments.camera, arguments.robot, arguments.seed);
  check_waypoints(waypoints, rig.robot->limits());
  make_ready(files, arguments);
  const std::string base = base_of(arguments, *rig.camera);
  take_views({*rig.camera, *rig.robot, rig.clock, chain, base}, waypoints, files.views, arguments.capture,
             terminal_progress());
  const std::vector<MapView> views = load_views(files, waypoints.size());
  const Stopwatch start;
  const MapPoses map{base, chain, !arguments.no_refine, poses_of(views, chain, arguments)};
  const std::vector<MapPoint> points = join_views(views, transforms(map.poses), arguments.cloud);
  const double joined_ms = start.ms();
  write_map(files, points, views, map, arguments.cloud);
  print_summary(files, views, map, points.size(), joined_ms, arguments.json);
}

}  // namespace

void add_map_command(CLI::App& program, Outcome& /*outcome*/) {
  CLI::App& command = *program.add_subcommand("map", "drives the waypoints and builds a 3D map of the bay");
  const auto arguments = std::make_shared<MapArguments>();
  command.add_option("--camera", arguments->camera, "sim:SCENE")->required()->type_name("URI");
  command.add_option("--robot", arguments->robot, "sim or serial:DEVICE")->required()->type_name("URI");
  CLI::Option_group& where = *command.add_option_group("where to look");
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
  command.add_option("--geometry", arguments->geometry, "of the robot, as rva calibrate writes it")
      ->type_name("FILE");
  command.add_option("--base", arguments->base,
                     "name of the place where the robot's foot stands; captures of one base share a frame");
  command.add_option("--frames", arguments->capture.frames, "depth frames of each view")
      ->check(frame_count())
      ->capture_default_str();
  command.add_option("--seed", arguments->seed, "of a simulation's noise")
      ->check(any_seed())
      ->capture_default_str();
  add_flags(command, arguments->cloud);
  add_flags(command, arguments->refinement);
  command.add_flag("--no-refine", arguments->no_refine,
                   "leave the views where the joints have them, as the thesis did");
  command.add_flag("--resume", arguments->resume,
                   "go on with a map that was interrupted: take only the missing views");
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier map");
  command.add_flag("--json", arguments->json, "print JSON");
  command.callback([arguments] { map_bay(*arguments); });
}

}  // namespace rva::cli
