// What is kept of a capture for a map.
#pragma once

#include <optional>
#include <string>

#include "cloud/depth_view.hpp"
#include "depth/capture.hpp"
#include "geometry/pan_tilt.hpp"

namespace rva {

struct ViewColor {
  ColorImage image;
  Intrinsics camera;
  Transform color_from_depth = Transform::Identity();
};

/// One view of a robot that stands still and turns its camera.
struct MapView {
  std::string name;  ///< for a person: where the capture is
  PanTilt joints;    ///< as the servos said
  DepthView depth;
  std::optional<ViewColor> color;  ///< the last image, when light had settled
};

/// @param name for errors
/// @throws Error when it does not say at which angles the joints were, its lens bends rays, or a frame cannot
///         be read
[[nodiscard]] MapView load_map_view(const Capture& capture, const std::string& name);

/// As above, where the joints are known otherwise, or there are none.
[[nodiscard]] MapView load_map_view(const Capture& capture, const std::string& name, const PanTilt& joints);

}  // namespace rva
