// Takes a capture at each of a list of waypoints (algorithm 1 of the thesis, lines 3 to 8).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "geometry/pan_tilt.hpp"
#include "map/pose_return.hpp"
#include "map/rig.hpp"

namespace rva {

/// Earlier captures of the same waypoints: the camera is to return to their poses.
struct Baseline {
  std::filesystem::path folder;     ///< of captures as take_views() names them
  std::size_t captures_each = 1;    ///< of each view, one after the other; divides the number of waypoints
  PoseReturnOptions pose_return{};  ///< how closely to return to the poses
  OnApproach on_approach{};         ///< may be empty
};

/// Options of the captures of a map's views.
struct ViewCaptureOptions {
  std::size_t frames = 10;             ///< depth frames of each view
  std::size_t settling = 2;            ///< frames dropped before them, while the robot comes to rest
  bool lamp = false;                   ///< take as many frames under the lamp, too; the camera must have one
  std::optional<Baseline> baseline{};  ///< its poses are approached up to as often as it states
};

/// The folder name of a waypoint's capture, by the waypoint's number from 0: "000", "001", ...
[[nodiscard]] std::string view_name(std::size_t number);

/// Moves to each waypoint without a capture, from smaller angles in both joints (robot/dither.hpp), and
/// writes a capture folder with the reported joint angles and the pose in the foot's frame. Captures are
/// complete or absent, so that an interrupted run resumes by calling again. If poses of a baseline may be
/// approached more than once, each capture's pose states how close it is and after how many approaches.
/// @param waypoints    within the robot's limits, which is checked before anything moves
/// @param folder       must exist; may contain captures of the same waypoints
/// @throws UsageError  when a waypoint is beyond the limits
/// @throws Error       when an existing capture belongs to another waypoint, camera or base, or was taken
///                     with other options; when the robot or the camera fails; when a file cannot be written
/// @throws Interrupted after stopping the robot
void take_views(const Rig& rig, const std::vector<PanTilt>& waypoints, const std::filesystem::path& folder,
                const ViewCaptureOptions& options, const Progress& progress);

}  // namespace rva
