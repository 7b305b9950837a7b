// Algorithm 1 of the thesis, lines 3 to 8: from waypoint to waypoint, a capture at each.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "camera/camera.hpp"
#include "core/clock.hpp"
#include "core/progress.hpp"
#include "geometry/pan_tilt.hpp"
#include "robot/robot.hpp"

namespace rva {

/// The robot that carries the camera.
struct Rig {
  Camera& camera;
  Robot& robot;
  const Clock& clock;
  const PanTiltChain& chain;
  const std::string& base;  ///< name of the place where its foot stands
};

struct ViewCaptureOptions {
  std::size_t frames = 10;   ///< depth frames of each view
  std::size_t settling = 2;  ///< frames thrown away before, while the robot comes to rest
  bool lamp = false;         ///< as many frames under the camera's lamp, too, which it must have
};

/// Where the capture of a waypoint is, by its number from 0: "000", "001", ...
[[nodiscard]] std::string view_name(std::size_t number);

/// Goes to each waypoint whose capture is not there yet, from below in both joints (robot/dither.hpp), and
/// writes a capture folder with where the joints said they were; poses are in the foot's frame. A capture is
/// there whole or not at all, so that whoever was interrupted goes on by calling again.
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
