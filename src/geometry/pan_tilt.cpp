#include "geometry/pan_tilt.hpp"

#include <numbers>

namespace rva {
namespace {

Transform shifted(double right_m, double forward_m, double up_m) {
  return Transform(Eigen::Translation3d(right_m, forward_m, up_m));
}

Transform turned(double angle_deg, const Eigen::Vector3d& axis) {
  return Transform(Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180.0, axis));
}

// The robot's x right, y forward, z up from a camera's x right, y down, z forward.
Transform robot_axes_from_camera_axes() {
  Transform turn = Transform::Identity();
  turn.linear() << 1, 0, 0,  //
      0, 0, 1,               //
      0, -1, 0;
  return turn;
}

}  // namespace

Transform foot_from_camera(const PanTiltChain& chain, const PanTilt& joints) {
  const Transform foot_from_servo1 =
      shifted(0.0, 0.0, chain.pan_height_m) * turned(joints.pan_deg, Eigen::Vector3d::UnitZ());
  const Transform servo1_from_bracket = shifted(0.0, chain.bracket_forward_m, chain.bracket_height_m) *
                                        turned(joints.tilt_deg, Eigen::Vector3d::UnitX());
  const Transform bracket_from_camera =
      shifted(chain.camera_right_m, chain.camera_forward_m, chain.camera_up_m) *
      robot_axes_from_camera_axes();
  return foot_from_servo1 * servo1_from_bracket * bracket_from_camera;
}

}  // namespace rva
