#include "cli/rig_uri.hpp"

#include <cmath>
#include <functional>
#include <sstream>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"
#include "robot/serial_robot.hpp"
#include "sim/scene/scene_file.hpp"
#include "sim/simulated_camera.hpp"
#include "sim/simulated_robot.hpp"

namespace rva::cli {
namespace {

constexpr std::string_view simulated = "sim:";
constexpr std::string_view serial = "serial:";
constexpr std::string_view joints_file = ",joints=";

// Servos rest somewhere within the step that they report.
SimulatedRobotOptions as_built() {
  SimulatedRobotOptions options;
  options.rest_error_deg = 0.16;
  return options;
}

PanTilt read_joints(const std::string& path) {
  std::istringstream text(read_text_file(path));
  PanTilt joints;
  constexpr double most_deg = 180.0;
  if (text >> joints.pan_deg >> joints.tilt_deg && std::abs(joints.pan_deg) <= most_deg &&
      std::abs(joints.tilt_deg) <= most_deg)
    return joints;
  throw Error(printable(path), "does not hold two angles", "write pan and tilt in degrees into it");
}

/// What a scene's camera is told to follow.
struct SimulatedView {
  std::string scene;
  std::string joints;  ///< file with the angles; empty where there is none
};

SimulatedView parse(const std::string& camera) {
  if (!camera.starts_with(simulated) || camera.size() == simulated.size())
    throw UsageError(printable(camera), "no camera that a robot can carry", "give sim:SCENE");
  const std::size_t joints = camera.rfind(joints_file);
  if (joints == std::string::npos) return {camera.substr(simulated.size()), ""};
  if (camera.size() == joints + joints_file.size())
    throw UsageError(printable(camera), "names no file of joints", "give sim:SCENE,joints=FILE");
  return {camera.substr(simulated.size(), joints - simulated.size()),
          camera.substr(joints + joints_file.size())};
}

std::unique_ptr<Robot> open_serial(const std::string& uri) {
  if (uri == "none") throw UsageError("--robot", "none cannot turn the camera", "give sim or serial:DEVICE");
  if (!uri.starts_with(serial) || uri.size() == serial.size())
    throw UsageError(printable(uri), "no robot", "give sim or serial:DEVICE");
  return std::make_unique<SerialRobot>(uri.substr(serial.size()));
}

}  // namespace

OpenRig open_rig(const std::string& camera, const std::string& robot, std::uint64_t seed) {
  const SimulatedView view = parse(camera);
  Scene scene = load_scene(view.scene);
  OpenRig rig;
  std::function<PanTilt()> joints;
  if (robot == "sim") {
    rig.clock = unhurried_clock();
    auto simulation = std::make_unique<SimulatedRobot>(as_built(), rig.clock.now_s, seed);
    joints = [&truth = *simulation] { return truth.true_joints(); };
    rig.robot = std::move(simulation);
  } else {
    rig.clock = steady_clock();
    rig.robot = open_serial(robot);
    joints = [&said = *rig.robot] { return said.joints(); };
  }
  if (!view.joints.empty()) joints = [file = view.joints] { return read_joints(file); };
  rig.camera = std::make_unique<SimulatedCamera>(std::move(scene), StereoSensorOptions{}, seed,
                                                 ColorFrames::all, std::move(joints));
  return rig;
}

}  // namespace rva::cli
