// A camera and, where there is one, the robot that carries it, by name, for people who watch.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "camera/camera.hpp"
#include "camera/realsense/realsense.hpp"
#include "robot/robot.hpp"

namespace rva::cli {

/// In real time.
struct LiveRig {
  std::unique_ptr<Robot> robot;    ///< null where there is none
  std::unique_ptr<Camera> camera;  ///< may follow the robot: it is closed first
  /// Of a simulated scene with debris: true lets it be left there, false takes it away, which is how it
  /// begins. Empty elsewhere.
  std::function<void(bool)> simulated_work;
};

/// @param camera sim:SCENE, which follows a simulated robot; sim:SCENE,joints=FILE, which follows a file that
///               another program writes (`<pan_deg> <tilt_deg>`); replay:PATH, which begins again at its end;
///               realsense[:SERIAL]
/// @param robot  sim, serial:DEVICE, none
/// @param seed   of a simulated camera's noise and a simulated robot's errors
/// @throws UsageError for a URI of another form, or a recording on a robot; Error when what it names cannot
///         be opened
[[nodiscard]] LiveRig open_live_rig(const std::string& camera, const std::string& robot, std::uint64_t seed,
                                    const RealSenseOptions& realsense);

}  // namespace rva::cli
