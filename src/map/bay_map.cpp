#include "map/bay_map.hpp"

#include "capture/capture.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/path_text.hpp"
#include "core/stopwatch.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

MapView load_view(const fs::path& folder) {
  try {
    return load_map_view(*open_capture(folder), printable(folder));
  } catch (const Error& error) {
    throw Error(error.source(), error.problem(),
                "remove " + printable(folder) + " and resume: it is taken again");
  }
}

// Views get the names that they will have once the map has been moved to its final path.
std::vector<MapView> load_views(const MapFiles& files, const fs::path& taken_in, std::size_t count,
                                const Progress& progress) {
  std::vector<MapView> views;
  for (std::size_t i = 0; i < count; ++i) {
    views.push_back(load_view(taken_in / view_name(i)));
    views.back().name = printable(files.views.filename() / view_name(i));
    if (progress) progress("reading", i + 1, count);
  }
  return views;
}

std::vector<RefinedPose> poses_of(const std::vector<MapView>& views, const PanTiltChain& chain,
                                  const BayMapOptions& options) {
  if (options.refine) return refine_poses(views, chain, options.refinement);
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

}  // namespace

BayMap map_bay(const Rig& rig, const std::vector<PanTilt>& waypoints, const MapFiles& files,
               ViewFolder::Start start, const BayMapOptions& options, const Progress& progress) {
  check_map_cloud_options(options.cloud);
  check_options(options.refinement);
  check_waypoints(waypoints, rig.robot.limits());
  const ViewFolder folder(files.views, start, waypoints.size());
  take_views(rig, waypoints, folder.path(), options.capture, progress);
  BayMap map;
  map.views = load_views(files, folder.path(), waypoints.size(), progress);
  const Stopwatch since_read;
  map.poses = {.base = rig.base,
               .chain = rig.chain,
               .cloud = options.cloud,
               .refined = options.refine,
               .refinement = options.refinement,
               .poses = poses_of(map.views, rig.chain, options)};
  const std::vector<MapPoint> points = join_views(map.views, transforms(map.poses.poses), options.cloud);
  map.points = points.size();
  map.refine_and_join_ms = since_read.ms();
  if (points.empty())
    throw EmptyMapError(
        printable(files.ply),
        "would have no point: nothing was measured between the nearest and the farthest distance",
        "check the views in " + printable(folder.path()) + ", or map other distances");
  throw_if_interrupted();
  write_map(files, points, map.views, map.poses);
  return map;
}

}  // namespace rva
