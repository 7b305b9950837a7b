#include "map/map_files.hpp"

#include <fmt/format.h>

#include <cassert>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "core/durability.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/folder_lock.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "map/point_files.hpp"
#include "map/view_folder.hpp"

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

Json json_of(std::span<const MapPoint> points, std::span<const MapView> views, const MapPoses& map) {
  Json json = {{"format", "rva-map"},
               {"version", 1},
               {"base", map.base},
               {"refined", map.refined},
               {"points", points.size()},
               {"parameters", Json::object()},
               {"geometry", json_of(map.chain)},
               {"views", Json::array()}};
  const auto add = [&json](const auto& value, const OptionField& field) {
    json["parameters"][json_name(field)] = value;
  };
  MapCloudOptions::describe(map.cloud, add);
  if (map.refined) RefinementOptions::describe(map.refinement, add);
  for (std::size_t i = 0; i < views.size(); ++i)
    json["views"].push_back(json_of(views[i], map.poses[i], map));
  return json;
}

bool describes_a_map(const fs::path& poses) {
  try {
    const nlohmann::json json = parse_json(read_text_file(poses), "");
    return json.is_object() && json.value("format", Json()) == "rva-map";
  } catch (const Error&) {
    return false;
  }
}

// The parts of MAP.commit.
constexpr const char* ply_part = "ply";
constexpr const char* pcd_part = "pcd";
constexpr const char* poses_part = "json";
constexpr const char* earlier_views_part = "earlier.views";

bool is_commit(const fs::path& folder) {
  std::error_code failure;
  if (!fs::is_directory(fs::symlink_status(folder, failure))) return false;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    const fs::path name = entry.path().filename();
    if (name != ply_part && name != pcd_part && name != poses_part && name != earlier_views_part)
      return false;  // a folder of this name that is not part of a map
  }
  return !failure;
}

void move(const fs::path& from, const fs::path& to) {
  std::error_code failure;
  fs::rename(from, to, failure);
  if (failure)
    throw Error(printable(to), fmt::format("cannot be moved into place ({})", failure.message()),
                "check the permissions there, and repeat the command, which then completes the map");
}

// Each step can be repeated after the program was killed, since only files that were not moved yet are found.
void put_in_place(const MapFiles& files) {
  std::error_code ignored;
  const auto is_there = [&](const fs::path& path) { return fs::exists(fs::symlink_status(path, ignored)); };
  const fs::path next = next_views(files.views);
  const fs::path earlier = files.commit / earlier_views_part;
  if (is_there(next)) {
    if (is_there(files.views) && !is_there(earlier)) move(files.views, earlier);
    move(next, files.views);
  }
  // The poses come first, since they identify a map; the .ply comes last, so that it implies that the map
  // is complete.
  for (const auto& [part, file] :
       {std::pair{poses_part, files.poses}, {pcd_part, files.pcd}, {ply_part, files.ply}}) {
    if (is_there(files.commit / part)) move(files.commit / part, file);
  }
  sync_folder(fs::absolute(files.ply).parent_path());
  fs::remove_all(files.commit, ignored);
}

}  // namespace

MapFiles map_files(const fs::path& ply) {
  if (ply.extension() != ".ply" || ply.stem().empty())
    throw UsageError(printable(ply), "is not a file name for a map", "give one that ends in .ply");
  fs::path stem = ply;
  stem.replace_extension();
  return {.ply = ply,
          .pcd = stem.native() + ".pcd",
          .poses = stem.native() + ".json",
          .views = stem.native() + ".views",
          .commit = stem.native() + ".commit"};
}

void require_replaceable(const MapFiles& files, bool overwrite) {
  std::error_code ignored;
  const auto is_there = [&](const fs::path& file) { return fs::exists(fs::symlink_status(file, ignored)); };
  const auto is_file = [&](const fs::path& file) {
    return fs::is_regular_file(fs::symlink_status(file, ignored));
  };
  if (is_there(files.commit))
    throw Error(printable(files.commit), "exists, and is not part of a map",
                "move it away, or choose another name");
  for (const fs::path& file : {files.ply, files.pcd, files.poses}) {
    if (!is_there(file)) continue;
    if (!overwrite)
      throw Error(printable(file), "already exists",
                  is_there(next_views(files.views))
                      ? "resume and overwrite to complete the new map that was begun, overwrite without "
                        "resuming to begin it again, or choose another name"
                      : "choose another name, or overwrite it");
    if (!is_file(file) || !is_file(files.poses) || !describes_a_map(files.poses))
      throw Error(printable(file), "does not belong to an earlier map, so it is not replaced",
                  "choose another name");
  }
}

bool finish_map(const MapFiles& files) {
  if (!is_commit(files.commit)) return false;
  const std::unique_ptr<FolderLock> lock = FolderLock::try_lock(files.commit);
  if (lock != nullptr) put_in_place(files);
  return lock != nullptr;
}

void write_map(const MapFiles& files, std::span<const MapPoint> points, std::span<const MapView> views,
               const MapPoses& poses) {
  assert(views.size() == poses.poses.size());
  OutputFolder out(files.commit, {ply_part, pcd_part, poses_part}, Existing::refuse);
  write_ply(out.path(ply_part), points, PointFrame::robot_foot);
  write_pcd(out.path(pcd_part), points, PointFrame::robot_foot);
  write_file(out.path(poses_part), json_file_text(json_of(points, views, poses), 2));
  out.commit();
  put_in_place(files);
}

}  // namespace rva
