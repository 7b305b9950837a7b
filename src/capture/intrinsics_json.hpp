// The intrinsics of an imager as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "geometry/intrinsics.hpp"

namespace rva {

/// The keys of `depth` and `color` in capture.json (docs/captures.md), except the depth unit.
[[nodiscard]] inline nlohmann::ordered_json json_of(const Intrinsics& camera) {
  return {{"width", camera.width},
          {"height", camera.height},
          {"fx", camera.fx},
          {"fy", camera.fy},
          {"cx", camera.cx},
          {"cy", camera.cy},
          {"distortion_model", name_of(camera.distortion)},
          {"distortion", camera.coefficients}};
}

}  // namespace rva
