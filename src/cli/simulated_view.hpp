// Parses sim:SCENE and sim:SCENE,joints=FILE, the URIs of a simulated camera on a robot.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "geometry/pan_tilt.hpp"

namespace rva::cli {

/// The file of the scene of a camera's URI: `three-tools` is `data/scenes/three-tools.yaml` in the current
/// folder or beside the program's folder, unless a file has this name.
[[nodiscard]] std::filesystem::path scene_file(const std::string& scene);

/// The scene and the pan and tilt of a simulated camera.
struct SimulatedView {
  std::string scene;   ///< for scene_file()
  std::string joints;  ///< file with the angles; empty if there is none
};

/// Splits the URI of a simulated camera into its parts. @throws UsageError for a URI of another form
[[nodiscard]] SimulatedView parse_simulated_view(const std::string& camera);

/// The angles that a simulated camera follows: those of the view's file, which another program writes
/// (`<pan_deg> <tilt_deg>`), or else those of the robot. A call throws Error when the file cannot be read, or
/// does not contain two angles within 180 degrees.
[[nodiscard]] std::function<PanTilt()> joints_of(const SimulatedView& view,
                                                 std::function<PanTilt()> robot_joints);

}  // namespace rva::cli
