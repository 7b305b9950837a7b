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

/// Captures of the same waypoints, to whose poses the camera is to come back.
struct Baseline {
  std::filesystem::path folder;   ///< of captures as take_views() names them
  std::size_t captures_each = 1;  ///< of each view, one after the other; divides the number of waypoints
  PoseReturnOptions pose_return{};
  OnApproach on_approach{};  ///< may be empty
};

struct ViewCaptureOptions {
  std::size_t frames = 10;             ///< depth frames of each view
  std::size_t settling = 2;            ///< frames thrown away before, while the robot comes to rest
  bool lamp = false;                   ///< as many frames under the camera's lamp, too, which it must have
  std::optional<Baseline> baseline{};  ///< its poses are approached more than once where that says so
};

/// The folder name of a waypoint's capture, by the waypoint's number from 0: "000", "001", ...
[[nodiscard]] std::string view_name(std::size_t number);

/// Goes to each waypoint whose capture is not there yet, from below in both joints (robot/dither.hpp), and
/// writes a capture folder with where the joints said they were; poses are in the foot's frame. A capture is
/// there whole or not at all, so that whoever was interrupted goes on by calling again. Where a baseline's
/// poses were approached more than once, the capture's pose states what was reached.
/// @param waypoints within the robot's limits: checked before anything moves
/// @param folder    exists; what is in it are captures of the same waypoints
/// @throws UsageError a waypoint is beyond the limits
/// @throws Error       a capture that is there belongs to another waypoint or another camera; the robot or
/// the
///                     camera failed; a file cannot be written
/// @throws Interrupted the robot has been stopped
void take_views(const Rig& rig, const std::vector<PanTilt>& waypoints, const std::filesystem::path& folder,
                const ViewCaptureOptions& options, const Progress& progress);

}  // namespace rva
