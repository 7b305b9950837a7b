// Takes all captures of one side of an inspection.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "camera/live_camera.hpp"
#include "geometry/pan_tilt.hpp"
#include "inspect/noise_watch.hpp"
#include "map/pose_return.hpp"
#include "robot/drive.hpp"

namespace rva {

/// What sees and what moves; the robot may be missing.
struct InspectionRig {
  LiveCamera& camera;
  Drive* drive = nullptr;  ///< null where there is no robot
  PanTiltChain chain{};
};

/// How far a capture has come.
struct CaptureProgress {
  std::size_t view = 0;      ///< under way, from 0
  std::size_t views = 0;     ///< of the side
  std::size_t capture = 0;   ///< of the view, from 0
  std::size_t captures = 1;  ///< of each view
  std::size_t frame = 0;     ///< of the capture
  std::size_t frames = 0;
  std::size_t approach = 0;    ///< to the baseline's pose, from 0; only where more than one is allowed
  std::size_t approaches = 1;  ///< at most
};

/// Called while the side is taken, on the thread that takes it.
struct CaptureEvents {
  std::function<void(const CaptureProgress&)> progress;  ///< after each frame; throws Interrupted to end it
  std::function<void(NoiseSoFar)> noise;                 ///< every few frames
  std::function<void(const std::string& why)> waiting;   ///< for a device that is away; empty when it is back
};

/// The captures to be taken of one side.
struct SideCapture {
  /// One for each capture, those of a view one after the other; one, of any angles, where there is no robot.
  std::vector<PanTilt> waypoints;
  std::size_t captures_each = 1;  ///< of each view; divides the number of waypoints
  std::filesystem::path folder;
  std::string base;         ///< name of the position of the robot's foot
  std::size_t frames = 40;  ///< of each capture
  bool lamp = false;        ///< as many under the camera's lamp, too, which it must have
  /// Folder of the baseline's captures, to the poses of which the robot returns; empty if there is none.
  std::filesystem::path baseline{};
  PoseReturnOptions pose_return{};
};

/// With a robot, goes on where an earlier call was ended: captures that are there are not taken again. At the
/// end the robot returns to where it was before. A
/// camera or a robot that goes away is waited for, and only the capture under way is taken anew.
/// @return when the last capture was taken, as its capture states it (ISO 8601)
/// @throws UsageError  a waypoint is beyond the robot's limits
/// @throws Error       something else failed; captures that were complete stay
/// @throws Interrupted as `events.progress` does; the robot has been stopped
std::string take_side(const InspectionRig& rig, const SideCapture& side, const CaptureEvents& events);

}  // namespace rva
