#include "cli/robot_uri.hpp"

#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "robot/serial_robot.hpp"
#include "sim/simulated_robot.hpp"

namespace rva::cli {
namespace {

std::function<double()> lamp_of(Robot& robot) {
  return [&robot] { return robot.lamp().value_or(LampState{}).percent / 100.0; };
}

OpenRobot open_simulated_robot(const Clock& clock, std::uint64_t seed) {
  SimulatedRobotOptions options;
  options.rest_error_deg = 0.16;
  auto robot = std::make_unique<SimulatedRobot>(options, clock.now_s, seed);
  std::function<PanTilt()> joints = [&simulated = *robot] { return simulated.true_joints(); };
  std::function<double()> lamp = lamp_of(*robot);
  return {std::move(robot), std::move(joints), std::move(lamp)};
}

OpenRobot open_serial_robot(const std::string& uri) {
  constexpr std::string_view serial = "serial:";
  if (!uri.starts_with(serial) || uri.size() == serial.size())
    throw UsageError(printable(uri), "is not a robot", "give sim or serial:DEVICE");
  auto robot = std::make_unique<SerialRobot>(uri.substr(serial.size()));
  std::function<PanTilt()> joints = [&real = *robot] { return real.joints(); };
  std::function<double()> lamp = lamp_of(*robot);
  return {std::move(robot), std::move(joints), std::move(lamp)};
}

}  // namespace

OpenRobot open_robot(const std::string& uri, const Clock& clock, std::uint64_t seed) {
  if (uri == "none") return {};
  return uri == "sim" ? open_simulated_robot(clock, seed) : open_serial_robot(uri);
}

void require_real_robot(const std::string& uri) {
  if (uri == "sim")
    throw UsageError("--robot", "a simulated one cannot turn a real camera", "give serial:DEVICE or none");
}

}  // namespace rva::cli
