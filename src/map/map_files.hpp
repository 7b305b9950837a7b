// A map and where its views were taken from, as files beside each other.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "geometry/pan_tilt.hpp"
#include "map/map_cloud.hpp"
#include "map/pose_refinement.hpp"

namespace rva {

/// Of one map.
struct MapPoses {
  std::string base;  ///< name of the place where the robot's foot stood: the map is in its frame
  PanTiltChain chain;
  MapCloudOptions cloud;
  bool refined = false;
  RefinementOptions refinement;    ///< where it was
  std::vector<RefinedPose> poses;  ///< of each view
};

/// Of `path` (a .ply), its files: the map as .ply and as .pcd, its poses as .json.
struct MapFiles {
  std::filesystem::path ply;
  std::filesystem::path pcd;
  std::filesystem::path poses;
  std::filesystem::path views;  ///< the folder of the captures
  /// A complete map that is being put in its place, whole in this folder before any file of an earlier map is
  /// touched.
  std::filesystem::path commit;
};

/// @throws UsageError when the path does not end in .ply
[[nodiscard]] MapFiles map_files(const std::filesystem::path& ply);

/// @throws Error when one of the three is there and `overwrite` is false, or is not of an earlier map
void require_replaceable(const MapFiles& files, bool overwrite);

/// Completes what a killed program had begun to put in place; call it before anything else. Does nothing
/// where there is nothing to complete, or another program is at it.
/// @return whether there was something to complete
/// @throws Error when the disk refuses
bool finish_map(const MapFiles& files);

/// Writes all three into MAP.commit, then puts them in their places, with the captures of VIEWS.next where
/// there are any, in place of an earlier map's.
/// @param views of the map, with their names in the folder of captures
/// @throws Error when they cannot be written; nothing has been replaced then, unless putting in place failed,
///         which finish_map() completes
void write_map(const MapFiles& files, std::span<const MapPoint> points, std::span<const MapView> views,
               const MapPoses& poses);

}  // namespace rva
