// The residual error of calibration: rectified images are distorted by a fraction of a pixel.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "geometry/intrinsics.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva {

/// The displacement of one imager's rectified image, which varies slowly over the image: a sum of three waves
/// with at most 1.2 periods per image width. Along either axis its standard deviation is that of the options.
class RectificationError {
 public:
  /// No error at any pixel.
  RectificationError() = default;

  /// @param seed seed of this imager of this camera: the same seed gives the same error
  RectificationError(const StereoSensorOptions& options, const Intrinsics& imager, std::uint64_t seed);

  /// Displacement of pixel (u, v), in pixels.
  [[nodiscard]] Eigen::Vector2d at(double u, double v) const;
  /// Whether the error is 0 at every pixel.
  [[nodiscard]] bool is_none() const { return amplitude_px_ <= 0.0; }

 private:
  struct Wave {
    Eigen::Vector2d turns_per_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d phases = Eigen::Vector2d::Zero();  // radians, for the errors along u and v
  };
  double amplitude_px_ = 0.0;
  std::array<Wave, 3> waves_;
};

}  // namespace rva
