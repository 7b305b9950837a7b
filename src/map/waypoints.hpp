// Where the robot looks to see a whole bay.
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/pan_tilt.hpp"
#include "robot/robot_limits.hpp"

namespace rva {

/// More take hours to see and gigabytes to refine.
inline constexpr int most_waypoints = 1000;

/// Angles of one joint, evenly spread; both ends are among them.
struct GridAxis {
  double from_deg = 0.0;
  double to_deg = 0.0;
  int count = 1;  ///< 1: `from_deg` alone
};

/// Every pan at every tilt, one row of pans after the other, back and forth, so that the robot has little way
/// to go.
[[nodiscard]] std::vector<PanTilt> grid_waypoints(const GridAxis& pan, const GridAxis& tilt);

/// A file of waypoints in the order of travel (docs/mapping.md).
/// @throws Error naming the file and the field: not JSON, not a list of waypoints, of another version, none
/// or
///         more than 1000 of them, an angle that is missing or not a number
[[nodiscard]] std::vector<PanTilt> load_waypoints(const std::filesystem::path& path);

/// @throws UsageError naming the first waypoint beyond the limits, by its number from 1
void check_waypoints(const std::vector<PanTilt>& waypoints, const RobotLimits& limits);

}  // namespace rva
