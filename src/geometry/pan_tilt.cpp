#include "geometry/pan_tilt.hpp"

#include "core/units.hpp"

namespace rva {
namespace {

Transform turned(const JointAxis& joint, double angle_deg) {
  return Eigen::Translation3d(joint.at_m) * Eigen::AngleAxisd(radians(angle_deg), joint.axis);
}

// The twist of a frame that turns about an axis, with both given in that frame.
Twist twist_about(const JointAxis& joint) {
  Twist twist;
  twist << joint.axis, joint.at_m.cross(joint.axis);
  return twist;
}

JointAxis seen_from(const Transform& camera_from_carrier, const JointAxis& joint) {
  return {camera_from_carrier * joint.at_m, camera_from_carrier.linear() * joint.axis};
}

}  // namespace

Transform PanTiltChain::looking_forward(const Eigen::Vector3d& at_m) {
  Transform frame_from_camera = Transform::Identity();
  frame_from_camera.linear() << 1, 0, 0,  //
      0, 0, 1,                            //
      0, -1, 0;
  frame_from_camera.translation() = at_m;
  return frame_from_camera;
}

Transform foot_from_camera(const PanTiltChain& chain, const PanTilt& joints) {
  const Transform foot_from_servo1 = turned(chain.servo1, joints.pan_deg);
  const Transform servo1_from_bracket = turned(chain.bracket, joints.tilt_deg);
  return foot_from_servo1 * servo1_from_bracket * chain.bracket_from_camera;
}

JointTwists joint_twists(const PanTiltChain& chain, const PanTilt& joints) {
  const Transform servo1_from_camera = turned(chain.bracket, joints.tilt_deg) * chain.bracket_from_camera;
  const Transform camera_from_foot = foot_from_camera(chain, joints).inverse();
  return {twist_about(seen_from(camera_from_foot, chain.servo1)),
          twist_about(seen_from(servo1_from_camera.inverse(), chain.bracket))};
}

}  // namespace rva
