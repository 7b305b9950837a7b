// Waypoints: the joint angles at which a robot takes its views.
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/pan_tilt.hpp"
#include "robot/robot_limits.hpp"

namespace rva {

/// More waypoints would take hours to visit and gigabytes of memory to refine.
inline constexpr int most_waypoints = 1000;

/// Angles of one joint, evenly spread; both ends are among them.
struct GridAxis {
  double from_deg = 0.0;  ///< first angle
  double to_deg = 0.0;    ///< last angle
  int count = 1;          ///< 1: `from_deg` alone
};

/// Every pan angle at every tilt angle, row by row with alternating direction, so that the robot's path
/// is short.
[[nodiscard]] std::vector<PanTilt> grid_waypoints(const GridAxis& pan, const GridAxis& tilt);

/// Reads a file of waypoints in the order of travel (docs/mapping.md).
/// @throws Error naming the file and the field when it is not JSON, not a list of waypoints or of another
///         version; when there are no waypoints or more than most_waypoints; when an angle is missing or not
///         a number
[[nodiscard]] std::vector<PanTilt> load_waypoints(const std::filesystem::path& path);

/// Refuses waypoints that the robot cannot reach.
/// @throws UsageError naming the first waypoint beyond the limits, by its number from 1
void check_waypoints(const std::vector<PanTilt>& waypoints, const RobotLimits& limits);

}  // namespace rva
