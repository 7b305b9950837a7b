// A capture, reduced to what a map needs.
#pragma once

#include <optional>
#include <string>

#include "capture/capture.hpp"
#include "geometry/pan_tilt.hpp"
#include "views/depth_view.hpp"

namespace rva {

/// The colour image of a view, with its camera.
struct ViewColor {
  ColorImage image;                                    ///< as the capture has it
  Intrinsics camera;                                   ///< intrinsics of the colour image
  Transform color_from_depth = Transform::Identity();  ///< from the depth imager to the colour imager
};

/// One view of a robot that turns its camera while its foot does not move.
struct MapView {
  std::string name;                ///< for the user: the capture's path
  PanTilt joints;                  ///< as reported by the servos
  DepthView depth;                 ///< mean over the frames
  std::optional<ViewColor> color;  ///< the last image, when brightness has settled
};

/// Loads a view: depth as the mean over all frames.
/// @param name for errors
/// @throws Error when the capture does not state the joint angles, its depth images have lens distortion, or
///         a frame cannot be read
[[nodiscard]] MapView load_map_view(const Capture& capture, const std::string& name);

/// The same with given joint angles, for captures that state none.
[[nodiscard]] MapView load_map_view(const Capture& capture, const std::string& name, const PanTilt& joints);

}  // namespace rva
