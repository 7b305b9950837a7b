// Maps a bay: algorithm 1 of the thesis.
#pragma once

#include <vector>

#include "core/error.hpp"
#include "core/progress.hpp"
#include "map/map_files.hpp"
#include "map/rig.hpp"
#include "map/view_capture.hpp"
#include "map/view_folder.hpp"
#include "map/waypoints.hpp"

namespace rva {

/// How views are captured and joined into a map.
struct BayMapOptions {
  ViewCaptureOptions capture;    ///< of the capture at each waypoint
  MapCloudOptions cloud;         ///< of the cloud that joins the views
  RefinementOptions refinement;  ///< of the poses; used if `refine`
  bool refine = true;            ///< false: poses are those of the joints, as in the thesis
};

/// A map that was written.
struct BayMap {
  std::vector<MapView> views;       ///< with the names of their captures in the folder of views
  MapPoses poses;                   ///< of the views, with the settings that they were made with
  std::size_t points = 0;           ///< of the cloud
  double refine_and_join_ms = 0.0;  ///< time that the poses and the cloud took, without reading and writing
};

/// No view measured anything within the distances of MapCloudOptions.
class EmptyMapError : public Error {
 public:
  using Error::Error;
};

/// Moves the camera to each waypoint and takes a capture there, corrects the poses that the joints give by
/// the surfaces that the views share, joins all views into one cloud in the foot's frame, and writes it. A
/// run that was interrupted is continued by `start` resume: only missing captures are taken.
/// @param waypoints at least one, within the robot's limits
/// @param files     to which finish_map() and require_replaceable() were applied
/// @throws UsageError when an option is out of range, or a waypoint is beyond the limits; nothing has moved
/// @throws EmptyMapError when there is no point; the captures stay in the folder of views
/// @throws Error when the robot, the camera or the disk fails, or a capture cannot be read
/// @throws Interrupted after stopping the robot
[[nodiscard]] BayMap map_bay(const Rig& rig, const std::vector<PanTilt>& waypoints, const MapFiles& files,
                             ViewFolder::Start start, const BayMapOptions& options, const Progress& progress);

}  // namespace rva
