// Forward kinematics of the robot, from its foot to its camera (thesis, equation 2.5).
#pragma once

#include <Eigen/Core>

#include "geometry/rigid_motion.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// Joint angles. Pan turns about the vertical, positive to the left (counterclockwise seen from above);
/// tilt is positive up. At 0, 0 the camera looks level along the foot's +y.
struct PanTilt {
  double pan_deg = 0.0;   ///< positive is to the left
  double tilt_deg = 0.0;  ///< positive is up
  bool operator==(const PanTilt&) const = default;
};

/// A servo's axis, in the frame of the part that carries the servo, given by a point on it and its direction.
/// A positive angle is a right-handed turn about the axis.
struct JointAxis {
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();   ///< a point on the axis, metres
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit length
};

/// The robot's geometry. Each frame has the foot's axes when all angles are 0: x right, y forward, z up. The
/// foot's origin is on the ground below the pan axis.
struct PanTiltChain {
  JointAxis servo1{{0.0, 0.0, 0.180}, Eigen::Vector3d::UnitZ()};   ///< pan, in the foot's frame
  JointAxis bracket{{0.0, 0.0, 0.060}, Eigen::Vector3d::UnitX()};  ///< tilt, in the first servo's frame
  /// The left imager sits beside the middle of the camera's body.
  Transform bracket_from_camera = looking_forward({-0.0175, 0.020, 0.010});

  /// The pose of a camera (x right, y down, z forward) at `at_m` in a frame with x right, y forward, z up,
  /// when the camera looks level along that frame's +y.
  [[nodiscard]] static Transform looking_forward(const Eigen::Vector3d& at_m);
};

/// foot_from_servo1 * servo1_from_bracket * bracket_from_camera. The thesis' world is the foot's frame.
[[nodiscard]] Transform foot_from_camera(const PanTiltChain& chain, const PanTilt& joints);

/// The camera's motion in its own frame per radian of each joint: the rotation vector (rad/rad), then the
/// translation of the camera's origin (m/rad).
struct JointTwists {
  Twist pan;   ///< per radian of the first joint
  Twist tilt;  ///< per radian of the second joint
};

/// The derivative of foot_from_camera() by both joint angles.
[[nodiscard]] JointTwists joint_twists(const PanTiltChain& chain, const PanTilt& joints);

}  // namespace rva
