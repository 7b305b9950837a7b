// A robot in a bay of boxes (tests/views/box_room.hpp), seen without a sensor.
#pragma once

#include <string>
#include <vector>

#include "map/map_view.hpp"
#include "tests/views/box_room.hpp"

namespace rva::test {

/// The foot stands on the floor; the room's axes are those of a camera.
inline Transform room_from_foot() { return PanTiltChain::looking_forward({0.0, 0.0, 0.25}).inverse(); }

struct BoxBayView {
  PanTilt joints;  ///< as the servos say
  PanTilt error;   ///< by which they err
  double noise_px = 0.05;
  std::uint64_t seed = 1;
};

inline PanTilt true_joints(const BoxBayView& how) {
  return {how.joints.pan_deg + how.error.pan_deg, how.joints.tilt_deg + how.error.tilt_deg};
}

inline MapView box_bay_view(const BoxBayView& how, const PanTiltChain& chain = {}, const Room& room = bay()) {
  const Transform pose = room_from_foot() * foot_from_camera(chain, true_joints(how));
  return {
      "view-" + std::to_string(how.seed), how.joints, view_of(room, pose, {how.noise_px, 0.0, how.seed}), {}};
}

/// Twelve views whose servos err by up to half a step.
inline std::vector<BoxBayView> twelve_views(double error_deg = 0.16) {
  Random random(7);
  std::vector<BoxBayView> views;
  std::uint64_t seed = 1;
  for (const double tilt_deg : {-45.0, -25.0, -5.0}) {
    for (const double pan_deg : {-50.0, -17.0, 17.0, 50.0})
      views.push_back({{pan_deg, tilt_deg},
                       {random.uniform(-error_deg, error_deg), random.uniform(-error_deg, error_deg)},
                       0.05,
                       seed++});
  }
  return views;
}

}  // namespace rva::test
