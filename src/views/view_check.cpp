#include "views/view_check.hpp"

#include <cmath>

namespace rva {
namespace {

constexpr double differs_in_most = 0.5;

}  // namespace

bool ViewCheck::moved_far() const {
  constexpr double far_px = 1.0;
  return registration && registration->trusted() && registered_px > far_px;
}

bool ViewCheck::is_aligned() const {
  return !motion.noticed() && !moved_far() && motion.differing <= differs_in_most;
}

bool ViewCheck::shows_other_view() const {
  constexpr double far_px = 3.0;
  return motion.differing > differs_in_most || (motion.noticed() && motion.displacement_px > far_px);
}

ViewCheck check_views(const DepthView& initial, const DepthView& final) {
  // Debris rarely fills this share of a view; a camera that turned by degrees changes more.
  constexpr double much = 0.1;
  ViewCheck check{view_motion(initial, final), std::nullopt};
  if (check.motion.noticed() || check.motion.differing < much) return check;
  check.registration = register_near_views(initial, final);
  check.registered_px = displacement_px(final, check.registration->initial_from_final, Transform::Identity());
  return check;
}

double displacement_px(const DepthView& view, const Transform& camera_from_view, const Transform& other) {
  constexpr int sampling_px = 16;
  double squares = 0.0;
  double count = 0.0;
  for (int v = 0; v < view.camera.height; v += sampling_px) {
    for (int u = 0; u < view.camera.width; u += sampling_px) {
      const auto disparity_px = static_cast<double>(view.disparity_px(u, v));
      if (disparity_px <= 0.0) continue;
      const Eigen::Vector3d point = view.camera.deproject({u, v}, view.stereo.depth_m(disparity_px));
      const Eigen::Vector3d here = camera_from_view * point;
      const Eigen::Vector3d there = other * point;
      if (here.z() <= 0.0 || there.z() <= 0.0) continue;
      squares += (view.camera.project(here) - view.camera.project(there)).squaredNorm();
      count += 1.0;
    }
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

Registration register_near_views(const DepthView& initial, const DepthView& final) {
  Registration nearby = register_views(initial, final, {Transform::Identity(), true});
  return nearby.trusted() ? nearby : register_views(initial, final);
}

}  // namespace rva
