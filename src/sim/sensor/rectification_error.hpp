// What calibration leaves: rectified images are bent by a fraction of a pixel.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "geometry/intrinsics.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva {

/// How far one imager's rectified image is off, slowly varying over the image: a sum of three waves of at
/// most 1.2 periods across the image, of the deviation that the options state along either axis.
class RectificationError {
 public:
  /// None anywhere.
  RectificationError() = default;

  /// @param seed of this imager of this camera: the same seed gives the same error
  RectificationError(const StereoSensorOptions& options, const Intrinsics& imager, std::uint64_t seed);

  /// px, of the pixel (u, v).
  [[nodiscard]] Eigen::Vector2d at(double u, double v) const;
  [[nodiscard]] bool is_none() const { return amplitude_px_ <= 0.0; }

 private:
  struct Wave {
    Eigen::Vector2d turns_per_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d phases = Eigen::Vector2d::Zero();  // of the errors along u and v
  };
  double amplitude_px_ = 0.0;
  std::array<Wave, 3> waves_;
};

}  // namespace rva
