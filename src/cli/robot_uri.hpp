// Opens robots by name, serial:DEVICE, and states how a simulated one is built.
#pragma once

#include <memory>
#include <string>

#include "robot/robot.hpp"
#include "sim/simulated_robot.hpp"

namespace rva::cli {

/// @throws UsageError for a URI of another form; Error when the device cannot be opened or is not a robot
[[nodiscard]] std::unique_ptr<Robot> open_serial_robot(const std::string& uri);

/// @throws UsageError for a simulated robot: it cannot turn a real camera
void require_real_robot(const std::string& uri);

/// Options of a simulated robot whose servos, like real ones, rest anywhere within the step that they report.
[[nodiscard]] SimulatedRobotOptions servos_as_built();

}  // namespace rva::cli
