#include "map/map_files.hpp"

#include <fmt/format.h>

#include <cassert>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
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

std::string poses_json(std::span<const MapPoint> points, std::span<const MapView> views,
                       const MapPoses& map) {
  Json json = {{"format", "rva-map"},
               {"version", 1},
               {"base", map.base},
               {"refined", map.refined},
               {"points", points.size()},
               {"parameters", Json::object()},
               {"geometry", Json::parse(robot_geometry_json(map.chain))},
               {"views", Json::array()}};
  const auto add = [&json](const auto& value, const OptionField& field) {
    json["parameters"][json_name(field)] = value;
  };
  MapCloudOptions::describe(map.cloud, add);
  if (map.refined) RefinementOptions::describe(map.refinement, add);
  for (std::size_t i = 0; i < views.size(); ++i)
    json["views"].push_back(json_of(views[i], map.poses[i], map));
  return json.dump(2) + "\n";
}

bool describes_a_map(const fs::path& poses) {
  try {
    const nlohmann::json json = parse_json(read_text_file(poses), "");
    return json.is_object() && json.value("format", Json()) == "rva-map";
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

MapFiles map_files(const fs::path& ply) {
  if (ply.extension() != ".ply" || ply.stem().empty())
    throw UsageError(printable(ply), "is no name of a map", "give one that ends in .ply");
  fs::path stem = ply;
  stem.replace_extension();
  return {ply, stem.native() + ".pcd", stem.native() + ".json", stem.native() + ".views"};
}

void require_replaceable(const MapFiles& files, bool overwrite) {
  std::error_code ignored;
  const auto is_there = [&](const fs::path& file) { return fs::exists(fs::symlink_status(file, ignored)); };
  const auto is_file = [&](const fs::path& file) {
    return fs::is_regular_file(fs::symlink_status(file, ignored));
  };
  for (const fs::path& file : {files.ply, files.pcd, files.poses}) {
    if (!is_there(file)) continue;
    if (!overwrite)
      throw Error(printable(file), "is there already", "choose another name, or give --overwrite");
    if (!is_file(file) || !is_file(files.poses) || !describes_a_map(files.poses))
      throw Error(printable(file), "is not of an earlier map, so it is not replaced", "choose another name");
  }
}

void write_map(const MapFiles& files, std::span<const MapPoint> points, std::span<const MapView> views,
               const MapPoses& poses) {
  assert(views.size() == poses.poses.size());
  fs::path beside = files.ply;
  beside.replace_extension(".files");
  const OutputFolder staging(beside, {}, Existing::refuse);  // never put in place itself
  write_ply(staging.path("ply"), points, PointFrame::robot_foot);
  write_pcd(staging.path("pcd"), points, PointFrame::robot_foot);
  write_file(staging.path("json"), poses_json(points, views, poses));
  // The poses first: they tell a map from what is none, and when the .ply is there, all is.
  for (const auto& [name, file] : {std::pair{"json", files.poses}, {"pcd", files.pcd}, {"ply", files.ply}}) {
    std::error_code failure;
    fs::rename(staging.path(name), file, failure);
    if (failure)
      throw Error(printable(file), fmt::format("cannot be put in place ({})", failure.message()),
                  "check the permissions there or choose another place");
  }
}

}  // namespace rva
