// Measures distances at pixels that the user selects.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "camera/live_camera.hpp"
#include "server/live_pictures.hpp"

namespace rva {

/// A point of the surface at a pixel.
struct MeasuredPoint {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< in the depth camera's frame
  double distance_m = 0.0;                               ///< from the depth imager, along the line of sight
};

/// Takes the median depth of the 5 x 5 pixels of the depth image around the point, if at least a third of
/// them are measured.
/// @param pixel of the stream's picture; in a colour picture, the nearest surface that is visible there is
///              measured
/// @return empty if there is no measurement, or if the pixel is outside the picture
[[nodiscard]] std::optional<MeasuredPoint> measure(const LiveFrame& live, Stream stream,
                                                   const Eigen::Vector2d& pixel);

}  // namespace rva
