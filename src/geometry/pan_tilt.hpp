// The robot's chain of joints: from its foot to the camera (thesis, equation 2.5).
#pragma once

#include "geometry/transform.hpp"

namespace rva {

/// Joint angles. Pan turns about the vertical, positive to the left (counterclockwise seen from above);
/// tilt is positive up. At 0, 0 the camera looks level along the foot's +y.
struct PanTilt {
  double pan_deg = 0.0;
  double tilt_deg = 0.0;
  bool operator==(const PanTilt&) const = default;
};

/// Where the joints are. Foot frame: x right, y forward, z up, origin on the ground below the pan axis.
struct PanTiltChain {
  double pan_height_m = 0.180;      ///< first servo above the ground
  double bracket_height_m = 0.060;  ///< tilt axis above the first servo
  double bracket_forward_m = 0.0;   ///< tilt axis in front of the pan axis
  double camera_forward_m = 0.020;  ///< depth imager in front of the tilt axis
  double camera_up_m = 0.010;
  double camera_right_m = -0.0175;  ///< the left imager sits beside the middle of the camera's body
};

/// foot_from_servo1 * servo1_from_bracket * bracket_from_camera, with the camera's axes as in transform.hpp.
[[nodiscard]] Transform foot_from_camera(const PanTiltChain& chain, const PanTilt& joints);

}  // namespace rva
