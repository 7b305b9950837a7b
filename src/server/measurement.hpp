// Distances and lengths, from pixels that a person points at.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "camera/live_camera.hpp"
#include "server/live_pictures.hpp"

namespace rva {

/// The surface under a pixel.
struct MeasuredPoint {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< in the depth camera's frame
  double distance_m = 0.0;                               ///< from the depth imager, along the line of sight
};

/// The median depth of the 5 x 5 pixels of the depth image around the place, if a third of them are measured.
/// @param pixel of the stream's picture; of a colour picture, the nearest surface that its imager sees there
/// @return empty where nothing is measured, or the pixel is outside
[[nodiscard]] std::optional<MeasuredPoint> measure(const LiveFrame& live, Stream stream,
                                                   const Eigen::Vector2d& pixel);

}  // namespace rva
