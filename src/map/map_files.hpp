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
};

/// @throws UsageError when the path does not end in .ply
[[nodiscard]] MapFiles map_files(const std::filesystem::path& ply);

/// @throws Error when one of the three is there and `overwrite` is false, or is not of an earlier map
void require_replaceable(const MapFiles& files, bool overwrite);

/// Writes all three beside, then puts them in their places, the .ply last.
/// @param views of the map, with their names in the folder of captures
/// @throws Error when they cannot be written; nothing has been replaced then, unless putting in place failed
void write_map(const MapFiles& files, std::span<const MapPoint> points, std::span<const MapView> views,
               const MapPoses& poses);

}  // namespace rva
