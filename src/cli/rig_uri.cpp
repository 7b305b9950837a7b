#include "cli/rig_uri.hpp"

#include <utility>

#include "cli/camera_uri.hpp"
#include "cli/robot_uri.hpp"
#include "cli/simulated_view.hpp"
#include "core/error.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"

namespace rva::cli {
namespace {

void require_robot(const std::string& uri) {
  if (uri == "none") throw UsageError("--robot", "none cannot turn the camera", "give sim or serial:DEVICE");
}

}  // namespace

OpenRig open_rig(const std::string& camera, const std::string& robot, std::uint64_t seed,
                 const RealSenseOptions& realsense) {
  OpenRig rig;
  rig.clock = robot == "sim" ? unhurried_clock() : steady_clock();
  if (is_device(camera)) {
    require_real_robot(robot);
    require_robot(robot);
    rig.robot = open_robot(robot, rig.clock, seed).robot;
    rig.camera = open_camera(camera, seed, {}, realsense);
    return rig;
  }
  const SimulatedView view = parse_simulated_view(camera);
  Scene scene = load_scene(scene_file(view.scene));
  require_robot(robot);
  OpenRobot opened = open_robot(robot, rig.clock, seed);
  rig.robot = std::move(opened.robot);
  rig.camera = std::make_unique<SimulatedCamera>(std::move(scene), StereoSensorOptions{}, seed,
                                                 ColorFrames::all, joints_of(view, std::move(opened.joints)));
  return rig;
}

}  // namespace rva::cli
