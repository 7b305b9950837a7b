// A camera on a robot.
#pragma once

#include <cstddef>
#include <string>

#include "camera/camera.hpp"
#include "core/clock.hpp"
#include "geometry/pan_tilt.hpp"
#include "robot/robot.hpp"

namespace rva {

/// A robot, the camera that it carries, and its geometry.
struct Rig {
  Camera& camera;             ///< carried by the robot
  Robot& robot;               ///< moves the camera; its foot stays
  const Clock& clock;         ///< for waiting until the robot rests
  const PanTiltChain& chain;  ///< geometry of the robot
  const std::string& base;    ///< name of the position of its foot
};

/// Approaches a waypoint from smaller angles in both joints (robot/dither.hpp), and drops the frames that
/// were exposed while the robot came to rest.
/// @param settling_frames number of frames to drop after those that are waiting
/// @return the reported joint angles at rest
/// @throws UsageError, Error, Interrupted  as approach() and Camera
PanTilt approach_and_settle(const Rig& rig, const PanTilt& waypoint, std::size_t settling_frames);

}  // namespace rva
