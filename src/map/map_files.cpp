#include "map/map_files.hpp"

#include <array>
#include <cassert>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "map/point_files.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const MapView& view, const RefinedPose& pose, const MapPoses& map) {
  Json json = {{"capture", view.name},
               {"pan_deg", view.joints.pan_deg},
               {"tilt_deg", view.joints.tilt_deg},
               {"foot_from_camera", to_row_major(pose.foot_from_camera)},
               {"foot_from_camera_by_joints", to_row_major(foot_from_camera(map.chain, view.joints))}};
  if (!map.refined) return json;
  json["moved_mm"] = pose.moved_mm;
  json["turned_deg"] = pose.turned_deg;
  json["neighbours"] = pose.neighbours;
  json["agreeing"] = pose.agreeing;
  json["residual_px"] = pose.residual_px;
  if (!pose.doubt.empty()) json["doubt"] = pose.doubt;
  return json;
}

std::string poses_json(std::span<const MapPoint> points, std::span<const MapView> views, const MapPoses& map,
                       const MapCloudOptions& options) {
  Json json = {{"format", "rva-map"},
               {"version", 1},
               {"base", map.base},
               {"refined", map.refined},
               {"points", points.size()},
               {"parameters", Json::object()},
               {"geometry", Json::parse(robot_geometry_json(map.chain))},
               {"views", Json::array()}};
  MapCloudOptions::describe(options, [&json](const auto& value, const OptionField& field) {
    json["parameters"][json_name(field)] = value;
  });
  for (std::size_t i = 0; i < views.size(); ++i)
    json["views"].push_back(json_of(views[i], map.poses[i], map));
  return json.dump(2) + "\n";
}

fs::path partial(const fs::path& path) { return path.native() + ".partial"; }

}  // namespace

MapFiles map_files(const fs::path& ply) {
  if (ply.extension() != ".ply" || ply.stem().empty())
    throw UsageError(printable(ply), "is no name of a map", "give one that ends in .ply");
  fs::path stem = ply;
  stem.replace_extension();
  return {ply, stem.native() + ".pcd", stem.native() + ".json", stem.native() + ".views"};
}

void write_map(const MapFiles& files, std::span<const MapPoint> points, std::span<const MapView> views,
               const MapPoses& poses, const MapCloudOptions& options) {
  assert(views.size() == poses.poses.size());
  const std::array all{files.ply, files.pcd, files.poses};
  try {
    write_ply(partial(files.ply), points);
    write_pcd(partial(files.pcd), points);
    write_file(partial(files.poses), poses_json(points, views, poses, options));
    for (const fs::path& file : all) fs::rename(partial(file), file);
  } catch (const fs::filesystem_error& error) {
    throw Error(printable(files.ply), "cannot be put in place (" + error.code().message() + ")",
                "check the permissions there or choose another place");
  } catch (const Error&) {
    std::error_code ignored;
    for (const fs::path& file : all) fs::remove(partial(file), ignored);
    throw;
  }
}

}  // namespace rva
