#include "cli/robot_uri.hpp"

#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "robot/serial_robot.hpp"
#include "sim/simulated_robot.hpp"

namespace rva::cli {
namespace {

constexpr std::string_view serial_scheme = "serial:";

bool names_port(const std::string& uri) {
  return uri.starts_with(serial_scheme) && uri.size() > serial_scheme.size();
}

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

}  // namespace

std::unique_ptr<SerialRobot> open_serial_robot(const std::string& uri) {
  if (!names_port(uri))
    throw UsageError(printable(uri), "is not a robot on a serial line", "give serial:DEVICE");
  return std::make_unique<SerialRobot>(uri.substr(serial_scheme.size()));
}

OpenRobot open_robot(const std::string& uri, const Clock& clock, std::uint64_t seed) {
  if (uri == "none") return {};
  if (uri == "sim") return open_simulated_robot(clock, seed);
  if (!names_port(uri)) throw UsageError(printable(uri), "is not a robot", "give sim or serial:DEVICE");
  std::unique_ptr<SerialRobot> robot = open_serial_robot(uri);
  std::function<PanTilt()> joints = [&real = *robot] { return real.joints(); };
  std::function<double()> lamp = lamp_of(*robot);
  return {std::move(robot), std::move(joints), std::move(lamp)};
}

void require_real_robot(const std::string& uri) {
  if (uri == "sim")
    throw UsageError("--robot", "a simulated one cannot turn a real camera", "give serial:DEVICE or none");
}

}  // namespace rva::cli
