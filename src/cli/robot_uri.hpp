// Opens robots by name: sim, serial:DEVICE, none.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/clock.hpp"
#include "geometry/pan_tilt.hpp"
#include "robot/robot.hpp"
#include "robot/serial_robot.hpp"

namespace rva::cli {

/// A robot, and the angles that a simulated camera on it follows.
struct OpenRobot {
  std::unique_ptr<Robot> robot;  ///< null for none
  /// The true angles of a simulated robot, the reported ones of another; empty for none.
  std::function<PanTilt()> joints;
  /// The brightness of its lamp, 0 to 1, which lights the view of a simulated camera; empty for none.
  std::function<double()> lamp;
};

/// @param uri   sim: a robot whose servos, like real ones, rest anywhere within the step that they report;
///              serial:DEVICE; none
/// @param clock by which a simulated robot moves
/// @param seed  of a simulated robot's errors
/// @throws UsageError for a URI of another form; Error when the device cannot be opened or is not a robot
[[nodiscard]] OpenRobot open_robot(const std::string& uri, const Clock& clock, std::uint64_t seed);

/// @param uri serial:DEVICE
/// @throws as open_robot()
[[nodiscard]] std::unique_ptr<SerialRobot> open_serial_robot(const std::string& uri);

/// Checks that a URI names a robot that can carry a real camera.
/// @throws UsageError for a simulated robot: it cannot turn a real camera
void require_real_robot(const std::string& uri);

}  // namespace rva::cli
