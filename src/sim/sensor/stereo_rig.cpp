#include "sim/sensor/stereo_rig.hpp"

#include "core/random.hpp"
#include "core/units.hpp"

namespace rva {

namespace {

constexpr int width_px = 848;
constexpr int height_px = 480;
constexpr double color_focal_px = 617.0;

Intrinsics centred(double focal_px) {
  Intrinsics imager;
  imager.width = width_px;
  imager.height = height_px;
  imager.fx = imager.fy = focal_px;
  imager.cx = (width_px - 1) / 2.0;
  imager.cy = (height_px - 1) / 2.0;
  return imager;
}

}  // namespace

StereoRig stereo_rig(const StereoSensorOptions& options) {
  StereoRig rig;
  rig.imager = centred(options.focal_px);
  rig.baseline_m = options.baseline_mm / mm_per_m;
  rig.color = centred(color_focal_px);
  rig.color_from_depth = Transform::Identity();
  rig.color_from_depth.translation() = Eigen::Vector3d(0.015, 0.0, 0.0);
  return rig;
}

Misalignment misalignment_of(const StereoSensorOptions& options, std::uint64_t seed) {
  constexpr std::uint64_t factory = 0xFAC7;
  constexpr std::uint64_t temperature = 0x7E47;
  Random device(mix(options.device, factory));
  Random capture(mix(options.device, temperature, seed));
  Misalignment misalignment;
  misalignment.row_offset_px = 0.5 * options.misalignment_px * device.uniform(-1.0, 1.0);
  misalignment.row_turn_px = options.misalignment_px * device.uniform(-1.0, 1.0);
  // Heat bends the frame between the imagers, which mostly causes an offset and less of the other errors.
  misalignment.offset_px = options.drift_px * capture.normal();
  misalignment.scale_px = 0.3 * options.drift_px * capture.normal();
  misalignment.row_offset_px += 0.3 * options.drift_px * capture.normal();
  misalignment.dots_px = options.drift_px * capture.normal();
  return misalignment;
}

}  // namespace rva
