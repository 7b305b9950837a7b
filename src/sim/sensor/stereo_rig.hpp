// The positions of the depth camera's parts, and their displacement by temperature.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva {

/// The displacement of the right imager's image relative to an ideal rig, and of the projector's pattern.
struct Misalignment {
  double offset_px = 0.0;      ///< along the row, constant over the image: shifts every disparity
  double scale_px = 0.0;       ///< along the row, linear from 0 at the centre to this at the right edge
  double row_offset_px = 0.0;  ///< across the rows, constant over the image
  double row_turn_px = 0.0;    ///< across the rows, linear from 0 at the centre to this at the right edge
  double dots_px = 0.0;        ///< of the projector's pattern along the row, in pixels of the imagers
};

/// Positions are in the frame of the depth (left infrared) imager: x right, y down, z forward.
struct StereoRig {
  Intrinsics imager;         ///< of both infrared imagers
  double baseline_m = 0.05;  ///< the right imager is at (baseline, 0, 0)
  /// Between the imagers (D400 datasheet, mechanical drawing).
  Eigen::Vector3d projector_m{0.0285, 0.0, 0.0};
  Eigen::Vector3d lamp_m{0.025, -0.02, 0.0};  ///< above the middle of the camera
  Intrinsics color;                           ///< with a narrower horizontal field of view of 69 deg
  Transform color_from_depth;                 ///< the colour imager is 15 mm to the left of the depth imager
};

/// The rig of a camera with these options.
[[nodiscard]] StereoRig stereo_rig(const StereoSensorOptions& options);

/// The camera's constant misalignment plus that caused by temperature during one capture.
/// @param seed seed of the capture
[[nodiscard]] Misalignment misalignment_of(const StereoSensorOptions& options, std::uint64_t seed);

}  // namespace rva
