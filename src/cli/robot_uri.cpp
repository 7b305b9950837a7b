#include "cli/robot_uri.hpp"

#include <string_view>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "robot/serial_robot.hpp"

namespace rva::cli {

std::unique_ptr<Robot> open_serial_robot(const std::string& uri) {
  constexpr std::string_view serial = "serial:";
  if (!uri.starts_with(serial) || uri.size() == serial.size())
    throw UsageError(printable(uri), "is not a robot", "give sim or serial:DEVICE");
  return std::make_unique<SerialRobot>(uri.substr(serial.size()));
}

void require_real_robot(const std::string& uri) {
  if (uri == "sim")
    throw UsageError("--robot", "a simulated one cannot turn a real camera", "give serial:DEVICE or none");
}

SimulatedRobotOptions servos_as_built() {
  SimulatedRobotOptions options;
  options.rest_error_deg = 0.16;
  return options;
}

}  // namespace rva::cli
