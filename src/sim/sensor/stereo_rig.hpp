// Where the parts of the depth camera sit, and how temperature moves them.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva {

/// How far the right imager's picture lies from where a perfect rig would put it.
struct Misalignment {
  double offset_px = 0.0;      ///< along the row, everywhere: shifts every disparity
  double scale_px = 0.0;       ///< along the row, at the image's right edge, growing from its centre
  double row_offset_px = 0.0;  ///< across the rows
  double row_turn_px = 0.0;    ///< across the rows, at the image's right edge, growing from its centre
  double dots_px = 0.0;        ///< the projector's pattern along the row, in pixels of the imagers
};

/// Frame: that of the depth (left infrared) imager; x right, y down, z forward.
struct StereoRig {
  Intrinsics imager;         ///< of both infrared imagers
  double baseline_m = 0.05;  ///< the right one is at (baseline, 0, 0)
  Eigen::Vector3d projector_m{0.0285, 0.0,
                              0.0};           ///< between the imagers (D400 datasheet, mechanical drawing)
  Eigen::Vector3d lamp_m{0.025, -0.02, 0.0};  ///< above the middle of the camera
  Intrinsics color;                           ///< narrower: 69 deg across
  Transform color_from_depth;                 ///< the colour imager is 15 mm to the left of the depth imager
};

[[nodiscard]] StereoRig stereo_rig(const StereoSensorOptions& options);

/// This camera's own misalignment and, drawn from `seed`, how its temperature adds to it during one capture.
[[nodiscard]] Misalignment misalignment_of(const StereoSensorOptions& options, std::uint64_t seed);

}  // namespace rva
