// Opens a camera and, if there is one, the robot that carries it, by name, for live use.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "camera/camera.hpp"
#include "camera/realsense/realsense.hpp"
#include "robot/robot.hpp"

namespace rva::cli {

/// A camera and a robot in real time.
struct LiveRig {
  std::unique_ptr<Robot> robot;    ///< null if there is none
  std::unique_ptr<Camera> camera;  ///< may read the robot's angles, so it is destroyed first
  /// For a simulated scene with debris or work: true shows the scene after the work, false before it, which
  /// is the initial state. Empty otherwise.
  std::function<void(bool)> simulated_work;
};

/// Opens the camera and the robot of `rva serve`.
/// @param camera sim:SCENE, which follows a simulated robot; sim:SCENE,joints=FILE, which follows a file that
///               another program writes (`<pan_deg> <tilt_deg>`); replay:PATH, which begins again at its end;
///               realsense[:SERIAL]
/// @param robot  sim, serial:DEVICE, none
/// @param seed   seed of a simulated camera's noise and a simulated robot's errors
/// @throws UsageError for a URI of another form, or a recording on a robot; Error when what it names cannot
///         be opened
[[nodiscard]] LiveRig open_live_rig(const std::string& camera, const std::string& robot, std::uint64_t seed,
                                    const RealSenseOptions& realsense);

}  // namespace rva::cli
