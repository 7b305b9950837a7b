// Infrared pairs of a textured plane in the light of a projector that turns with the camera.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "geometry/stereo_scale.hpp"
#include "infrared/dot_mask.hpp"
#include "stereo/space_time.hpp"

namespace rva::test {

inline const Intrinsics pair_camera{
    .width = 240, .height = 160, .fx = 425.0, .fy = 425.0, .cx = 119.5, .cy = 79.5};
inline constexpr double pair_baseline_m = 0.05;
inline constexpr StereoScale pair_stereo{.focal_baseline_m_px = 425.0 * pair_baseline_m};

/// z = depth_m + slope * x in the reference's frame, and nearer by a step from `step_x_m` to `end_x_m`.
struct Plane {
  double depth_m = 0.8;
  double slope = 0.0;
  double step_m = 0.0;
  double step_x_m = 10.0;
  double end_x_m = 20.0;

  [[nodiscard]] double depth_at(double x_m) const {
    return depth_m + slope * x_m - (x_m > step_x_m && x_m < end_x_m ? step_m : 0.0);
  }
};

/// Where a ray meets the plane, by steps that halve its error many times over.
inline Eigen::Vector3d meet(const Plane& plane, const Eigen::Vector3d& origin, const Eigen::Vector3d& ray) {
  double along = plane.depth_m;
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector3d point = origin + along * ray;
    along += (plane.depth_at(point.x()) - point.z()) / ray.z();
  }
  return origin + along * ray;
}

/// A dot in most cells of a grid of directions, somewhere in its cell.
inline double dots_at(double x, double y) {
  constexpr double cell = 9.0 / 425.0;
  double light = 0.0;
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      const auto i = static_cast<int>(std::floor(x / cell)) + di;
      const auto j = static_cast<int>(std::floor(y / cell)) + dj;
      Random random(mix(77, i + 1000, j + 1000));
      const double dx = x / cell - i - random.uniform();
      const double dy = y / cell - j - random.uniform();
      light += std::exp(-(dx * dx + dy * dy) / (2.0 * 0.12 * 0.12));
    }
  }
  return light;
}

inline double texture_at(double x_m, double y_m) {
  return 1.0 + 0.15 * std::sin(160.0 * x_m) * std::sin(130.0 * y_m + 0.7);
}

inline Image<float> eye_sees(const Plane& plane, const Transform& reference_from_view, double eye_x_m,
                             double speckle, std::uint64_t seed) {
  Random random(seed);
  Image<float> grey(pair_camera.width, pair_camera.height);
  const Eigen::Vector3d origin = reference_from_view * Eigen::Vector3d(eye_x_m, 0.0, 0.0);
  for (int v = 0; v < grey.height(); ++v) {
    for (int u = 0; u < grey.width(); ++u) {
      const Eigen::Vector3d ray =
          reference_from_view.linear() *
          pair_camera.deproject({static_cast<double>(u), static_cast<double>(v)}, 1.0);
      const Eigen::Vector3d point = meet(plane, origin, ray);
      const Eigen::Vector3d of_view = reference_from_view.inverse() * point;
      const double lit = dots_at((of_view.x() - 0.028) / of_view.z(), of_view.y() / of_view.z());
      grey(u, v) = static_cast<float>(texture_at(point.x(), point.y()) * (10.0 + 120.0 * lit) *
                                      std::max(0.2, 1.0 + speckle * random.normal()));
    }
  }
  return grey;
}

/// Dithered pairs of the plane, the first of them the reference; speckle is new in each image.
inline std::vector<StereoView> dithered_pairs(const Plane& plane, std::size_t count, double speckle,
                                              std::uint64_t seed) {
  Random random(seed);
  std::vector<StereoView> views;
  for (std::size_t k = 0; k < count; ++k) {
    const Transform turn =
        k == 0 ? Transform::Identity()
               : Transform(Eigen::AngleAxisd(random.uniform(-0.02, 0.02), Eigen::Vector3d::UnitX()) *
                           Eigen::AngleAxisd(random.uniform(-0.02, 0.02), Eigen::Vector3d::UnitY()));
    views.push_back(
        {log_grey(eye_sees(plane, turn.inverse(), 0.0, speckle, mix(seed, 2 * k))),
         log_grey(eye_sees(plane, turn.inverse(), pair_baseline_m, speckle, mix(seed, 2 * k + 1))), turn});
  }
  return views;
}

/// The disparity of the plane in the reference view, in pixels.
inline Image<float> true_disparity(const Plane& plane) {
  Image<float> disparity(pair_camera.width, pair_camera.height);
  for (int v = 0; v < disparity.height(); ++v) {
    for (int u = 0; u < disparity.width(); ++u) {
      const Eigen::Vector3d ray =
          pair_camera.deproject({static_cast<double>(u), static_cast<double>(v)}, 1.0);
      disparity(u, v) =
          static_cast<float>(pair_stereo.disparity_px(meet(plane, Eigen::Vector3d::Zero(), ray).z()));
    }
  }
  return disparity;
}

/// A surface that is so many pixels of disparity off everywhere.
inline ReferenceSurface off_by(const Image<float>& disparity, float error_px) {
  ReferenceSurface surface{pair_camera, disparity};
  for (float& value : surface.inverse_depth_per_m.pixels())
    value = (value + error_px) / static_cast<float>(pair_stereo.focal_baseline_m_px);
  return surface;
}

}  // namespace rva::test
