// A textured wall in the light of a projector that turns with the camera.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "infrared/dot_free_image.hpp"
#include "infrared/reference_surface.hpp"

namespace rva::test {

inline const Intrinsics wall_camera{
    .width = 320, .height = 240, .fx = 400.0, .fy = 400.0, .cx = 159.5, .cy = 119.5};
inline constexpr double wall_m = 0.6;

/// A square of the wall, in metres of its own plane, that is brighter or darker.
struct Spot {
  double x_m = 0.0;
  double y_m = 0.0;
  double side_m = 0.0;
  double brightness = 1.0;
};

struct WallLight {
  double brightness = 1.0;
  double noise = 0.02;  ///< relative, of each pixel
  double background = 20.0;
  double dots = 120.0;  ///< grey levels of a dot's middle
};

/// Stripes and a checkerboard: edges in both directions.
inline double albedo(double x_m, double y_m) {
  const double waves = 0.1 * std::sin(260.0 * x_m) * std::sin(190.0 * y_m + 1.0);
  const bool odd =
      (static_cast<int>(std::floor(x_m / 0.05)) + static_cast<int>(std::floor(y_m / 0.07))) % 2 != 0;
  return (odd ? 0.8 : 1.0) + waves;
}

/// From the middle of the nearest dot: rows 11 pixels apart, each shifted by 3 against the one before.
inline Eigen::Vector2d from_dot(int u, int v) {
  const int row = v / 11;
  return {std::fmod(u + 3.0 * row, 13.0) - 6.0, std::fmod(v, 11.0) - 5.0};
}

/// All pixels but those within 20 of the border.
inline Mask well_inside() {
  Mask mask(wall_camera.width, wall_camera.height);
  for (int v = 20; v < wall_camera.height - 20; ++v)
    std::fill_n(&mask(20, v), wall_camera.width - 40, mask_set);
  return mask;
}

/// The mean over the area of a pixel, as a sensor has it.
inline double mean_reflected(const Eigen::Matrix3d& reference_from_view, int u, int v,
                             const std::vector<Spot>& spots) {
  constexpr std::array within_px{-1.0 / 3.0, 0.0, 1.0 / 3.0};
  double sum = 0.0;
  for (const double dv : within_px) {
    for (const double du : within_px) {
      const Eigen::Vector3d ray = reference_from_view * wall_camera.deproject({u + du, v + dv}, 1.0);
      const double x_m = wall_m * ray.x() / ray.z();
      const double y_m = wall_m * ray.y() / ray.z();
      double reflected = albedo(x_m, y_m);
      for (const Spot& spot : spots) {
        if (std::abs(x_m - spot.x_m) < spot.side_m / 2 && std::abs(y_m - spot.y_m) < spot.side_m / 2)
          reflected *= spot.brightness;
      }
      sum += reflected;
    }
  }
  return sum / static_cast<double>(within_px.size() * within_px.size());
}

/// What the camera sees when turned by this rotation vector against the reference.
inline Image<float> wall_seen(const Eigen::Vector3d& turn_rad, std::uint64_t seed,
                              const WallLight& light = {}, const std::vector<Spot>& spots = {}) {
  Random random(seed);
  Eigen::Matrix3d view_from_reference = Eigen::Matrix3d::Identity();
  if (turn_rad.norm() > 0.0)
    view_from_reference = Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()).toRotationMatrix();
  Image<float> grey(wall_camera.width, wall_camera.height);
  for (int v = 0; v < grey.height(); ++v) {
    for (int u = 0; u < grey.width(); ++u) {
      const double reflected = mean_reflected(view_from_reference.transpose(), u, v, spots);
      const double dot = light.dots * std::exp(-std::pow(from_dot(u, v).norm(), 2) / 2.0);
      grey(u, v) = static_cast<float>(light.brightness * reflected * (light.background + dot) *
                                      (1.0 + light.noise * random.normal()));
    }
  }
  return grey;
}

inline ReferenceSurface wall_surface() {
  return {wall_camera, Image<float>(wall_camera.width, wall_camera.height, static_cast<float>(1.0 / wall_m))};
}

inline Transform turned(const Eigen::Vector3d& turn_rad) {
  return turn_rad.norm() > 0.0 ? Transform(Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()))
                               : Transform::Identity();
}

/// Rotation vectors a few servo steps apart, the first one none.
inline std::vector<Eigen::Vector3d> dithers(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Eigen::Vector3d> turns{Eigen::Vector3d::Zero()};
  while (turns.size() < count)
    turns.emplace_back(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02),
                       random.uniform(-0.001, 0.001));
  return turns;
}

/// Views at these turns, whose poses are known exactly.
inline std::vector<InfraredView> views_at(const std::vector<Eigen::Vector3d>& turns_rad, std::uint64_t seed,
                                          const WallLight& light = {}, const std::vector<Spot>& spots = {}) {
  std::vector<InfraredView> views;
  for (const Eigen::Vector3d& turn : turns_rad)
    views.emplace_back(wall_seen(turn, mix(seed, views.size()), light, spots), turned(turn));
  return views;
}

}  // namespace rva::test
