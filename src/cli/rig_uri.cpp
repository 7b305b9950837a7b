#include "cli/rig_uri.hpp"

#include <functional>
#include <utility>

#include "cli/camera_uri.hpp"
#include "cli/robot_uri.hpp"
#include "cli/simulated_view.hpp"
#include "core/error.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"
#include "sim/simulated_robot.hpp"

namespace rva::cli {
namespace {

std::unique_ptr<Robot> open_robot(const std::string& uri) {
  if (uri == "none") throw UsageError("--robot", "none cannot turn the camera", "give sim or serial:DEVICE");
  return open_serial_robot(uri);
}

}  // namespace

OpenRig open_rig(const std::string& camera, const std::string& robot, std::uint64_t seed,
                 const RealSenseOptions& realsense) {
  if (is_device(camera)) {
    require_real_robot(robot);
    std::unique_ptr<Robot> real = open_robot(robot);
    return {std::move(real), open_camera(camera, seed, {}, realsense), steady_clock()};
  }
  const SimulatedView view = parse_simulated_view(camera);
  Scene scene = load_scene(view.scene);
  OpenRig rig;
  std::function<PanTilt()> joints;
  if (robot == "sim") {
    rig.clock = unhurried_clock();
    auto simulation = std::make_unique<SimulatedRobot>(servos_as_built(), rig.clock.now_s, seed);
    joints = [&truth = *simulation] { return truth.true_joints(); };
    rig.robot = std::move(simulation);
  } else {
    rig.clock = steady_clock();
    rig.robot = open_robot(robot);
    joints = [&said = *rig.robot] { return said.joints(); };
  }
  if (!view.joints.empty()) joints = [file = view.joints] { return read_joints(file); };
  rig.camera = std::make_unique<SimulatedCamera>(std::move(scene), StereoSensorOptions{}, seed,
                                                 ColorFrames::all, std::move(joints));
  return rig;
}

}  // namespace rva::cli
