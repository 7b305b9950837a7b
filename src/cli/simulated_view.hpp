// Parses sim:SCENE and sim:SCENE,joints=FILE, the URIs of a simulated camera on a robot.
#pragma once

#include <string>

#include "geometry/pan_tilt.hpp"

namespace rva::cli {

struct SimulatedView {
  std::string scene;
  std::string joints;  ///< file with the angles; empty if there is none
};

/// @throws UsageError for a URI of another form
[[nodiscard]] SimulatedView parse_simulated_view(const std::string& camera);

/// Reads the angles from a file that another program writes: `<pan_deg> <tilt_deg>`.
/// @throws Error when it cannot be read, or does not contain two angles within 180 degrees
[[nodiscard]] PanTilt read_joints(const std::string& path);

}  // namespace rva::cli
