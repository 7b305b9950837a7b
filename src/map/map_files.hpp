// The files of a map and of the poses of its views.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "geometry/pan_tilt.hpp"
#include "map/map_cloud.hpp"
#include "map/pose_refinement.hpp"

namespace rva {

/// The poses of a map's views, and the settings that it was made with.
struct MapPoses {
  std::string base;              ///< name of the position of the robot's foot; the map is in the foot's frame
  PanTiltChain chain;            ///< geometry of the robot
  MapCloudOptions cloud;         ///< options with which the views were joined
  bool refined = false;          ///< whether poses were refined by refine_poses()
  RefinementOptions refinement;  ///< used if `refined`
  std::vector<RefinedPose> poses;  ///< one per view
};

/// The paths of a map's files: the map as .ply and .pcd, its poses as .json, and two folders.
struct MapFiles {
  std::filesystem::path ply;    ///< the map as PLY
  std::filesystem::path pcd;    ///< the map as PCD
  std::filesystem::path poses;  ///< the poses as JSON
  std::filesystem::path views;  ///< the folder of the captures
  /// The folder in which a new map is written completely before any file of an earlier map is replaced.
  std::filesystem::path commit;
};

/// The paths for a map.
/// @param ply the path of its .ply file
/// @throws UsageError when the path does not end in .ply
[[nodiscard]] MapFiles map_files(const std::filesystem::path& ply);

/// Checks that a map may be written.
/// @throws Error when one of the three files exists and `overwrite` is false, or when it does not belong to
///         an earlier map; when `commit` exists
void require_replaceable(const MapFiles& files, bool overwrite);

/// Completes the replacement that a killed program had begun in write_map(); must be called before anything
/// else. Does nothing when there is nothing to complete, or another program is completing it.
/// @return whether a replacement was completed
/// @throws Error when a file cannot be renamed
bool finish_map(const MapFiles& files);

/// Writes the three files into MAP.commit, then renames them to their final paths, along with the captures in
/// VIEWS.next, if any; these replace the files and captures of an earlier map.
/// @param views of the map; their names are those in the folder of captures
/// @throws Error when a file cannot be written or renamed; nothing has then been replaced, unless renaming
///         failed, which finish_map() completes
void write_map(const MapFiles& files, std::span<const MapPoint> points, std::span<const MapView> views,
               const MapPoses& poses);

}  // namespace rva
