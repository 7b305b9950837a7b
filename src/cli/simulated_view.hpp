// sim:SCENE and sim:SCENE,joints=FILE: what a simulated camera on a robot looks at, and what it follows.
#pragma once

#include <string>

#include "geometry/pan_tilt.hpp"

namespace rva::cli {

struct SimulatedView {
  std::string scene;
  std::string joints;  ///< file with the angles; empty where there is none
};

/// @throws UsageError for a URI of another form
[[nodiscard]] SimulatedView parse_simulated_view(const std::string& camera);

/// Of a file that another program writes: `<pan_deg> <tilt_deg>`. @throws Error
[[nodiscard]] PanTilt read_joints(const std::string& path);

}  // namespace rva::cli
