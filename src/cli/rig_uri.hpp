// Opens a camera and the robot that carries it, by name.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "camera/camera.hpp"
#include "camera/realsense/realsense.hpp"
#include "core/clock.hpp"
#include "robot/robot.hpp"

namespace rva::cli {

/// A camera, a robot, and the clock by which they move: with a simulated robot, it advances as fast as the
/// work is done.
struct OpenRig {
  std::unique_ptr<Robot> robot;    ///< carries the camera; simulated or on a serial port
  std::unique_ptr<Camera> camera;  ///< may read the robot's angles
  Clock clock;                     ///< for waiting and for the frames of a simulated camera
};

/// Opens the camera and the robot of `rva map`.
/// @param camera sim:SCENE, which follows the true angles of a simulated robot, or the angles that another
///               robot reports; sim:SCENE,joints=FILE, which follows a file that another program writes
///               (`<pan_deg> <tilt_deg>`); realsense[:SERIAL], on a serial robot
/// @param robot  sim, serial:DEVICE
/// @param seed   seed of a simulated camera's noise and a simulated robot's errors
/// @throws UsageError for a URI of another form; Error when what it names cannot be opened
[[nodiscard]] OpenRig open_rig(const std::string& camera, const std::string& robot, std::uint64_t seed,
                               const RealSenseOptions& realsense);

}  // namespace rva::cli
