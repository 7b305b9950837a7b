// A camera on a robot.
#pragma once

#include <cstddef>
#include <string>

#include "camera/camera.hpp"
#include "core/clock.hpp"
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

/// Approaches a waypoint from below in both joints (robot/dither.hpp) and drops the frames that were exposed
/// while the robot came to rest. @return joints() at rest
/// @param settling_frames that are dropped after those that wait
/// @throws UsageError, Error, Interrupted  as approach() and Camera
PanTilt approach_and_settle(const Rig& rig, const PanTilt& waypoint, std::size_t settling_frames);

}  // namespace rva
