// A room of boxes that is seen without a sensor: exact depth, and noise only as asked for.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "geometry/transform.hpp"
#include "views/depth_view.hpp"

namespace rva::test {

using Box3 = Eigen::AlignedBox3d;

/// World frame: x right, y down, z forward, metres, as a camera that has not moved.
struct Room {
  std::vector<Box3> boxes;
};

inline Box3 box(double x0, double x1, double y0, double y1, double z0, double z1) {
  return {Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1)};
}

/// A bay: floor, far wall, two ribs, three stringers across at uneven distances.
inline Room bay() {
  return {{box(-1.0, 1.0, 0.25, 0.30, -1.0, 2.0), box(-1.0, 1.0, -1.0, 0.3, 1.2, 1.3),
           box(-0.50, -0.45, -1.0, 0.3, -1.0, 2.0), box(0.45, 0.50, -1.0, 0.3, -1.0, 2.0),
           box(-1.0, 1.0, 0.21, 0.25, 0.55, 0.58), box(-1.0, 1.0, 0.21, 0.25, 0.80, 0.83),
           box(-1.0, 1.0, 0.21, 0.25, 1.00, 1.03)}};
}

inline Intrinsics small_camera() {
  Intrinsics camera;
  camera.width = 424;
  camera.height = 240;
  camera.fx = camera.fy = 212.0;
  camera.cx = 211.5;
  camera.cy = 119.5;
  return camera;
}

inline constexpr double baseline_m = 0.05;

/// A pose from where it stands and how it is turned: to the right about y, down about x.
inline Transform pose(double x_m, double z_m, double right_deg, double down_deg = 15.0) {
  constexpr double rad = std::numbers::pi / 180.0;
  Transform world_from_camera(Eigen::Translation3d(x_m, 0.0, z_m));
  world_from_camera.rotate(Eigen::AngleAxisd(right_deg * rad, Eigen::Vector3d::UnitY()));
  world_from_camera.rotate(Eigen::AngleAxisd(-down_deg * rad, Eigen::Vector3d::UnitX()));
  return world_from_camera;
}

/// Depth along z of the first box on a pixel's ray; 0 where there is none.
inline double depth_at(const Room& room, const Transform& world_from_camera, const Intrinsics& camera, int u,
                       int v) {
  const Eigen::Vector3d origin = world_from_camera.translation();
  const Eigen::Vector3d ray = world_from_camera.linear() *
                              Eigen::Vector3d((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
  double nearest = std::numeric_limits<double>::max();
  for (const Box3& solid : room.boxes) {
    double enter = 0.0;
    double leave = std::numeric_limits<double>::max();
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (solid.min()[axis] - origin[axis]) / ray[axis];
      const double b = (solid.max()[axis] - origin[axis]) / ray[axis];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (enter > 0.0 && enter < leave) nearest = std::min(nearest, enter);
  }
  return nearest < std::numeric_limits<double>::max() ? nearest : 0.0;
}

struct ViewNoise {
  double noise_px = 0.0;   ///< of each pixel by itself
  double offset_px = 0.0;  ///< of all
  std::uint64_t seed = 1;
};

inline DepthView view_of(const Room& room, const Transform& world_from_camera, const ViewNoise& how = {},
                         const Intrinsics& camera = small_camera()) {
  DepthView view{camera,
                 {.focal_baseline_m_px = camera.fx * baseline_m},
                 Image<float>(camera.width, camera.height),
                 Image<float>(camera.width, camera.height)};
  Random random(how.seed);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const double depth_m = depth_at(room, world_from_camera, camera, u, v);
      if (depth_m <= 0.0) continue;
      const double disparity_px =
          view.stereo.disparity_px(depth_m) + how.offset_px + how.noise_px * random.normal();
      view.disparity_px(u, v) = static_cast<float>(disparity_px);
      view.deviation_px(u, v) = static_cast<float>(how.noise_px);
    }
  }
  return view;
}

struct PoseError {
  double mm = 0.0;
  double deg = 0.0;
};

inline PoseError error_of(const Transform& found, const Transform& truth) {
  const Transform between = truth.inverse() * found;
  return {1000.0 * between.translation().norm(),
          Eigen::AngleAxisd(between.linear()).angle() * 180.0 / std::numbers::pi};
}

}  // namespace rva::test
