#include "geometry/intrinsics.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace rva {
namespace {

// Brown's polynomial at a point of the plane z = 1 (Brown 1966; OpenCV's and librealsense's coefficients).
Eigen::Vector2d brown(const Eigen::Vector2d& point, const std::array<double, 5>& coefficients) {
  const auto [k1, k2, p1, p2, k3] = coefficients;
  const double x = point.x();
  const double y = point.y();
  const double r2 = point.squaredNorm();
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + 2.0 * p2 * x * y + p1 * (r2 + 2.0 * y * y)};
}

// The point that brown() takes to `target`, by fixed-point iteration: a contraction for lenses whose
// distortion is a small part of the image, as those of depth cameras are.
Eigen::Vector2d inverse_brown(const Eigen::Vector2d& target, const std::array<double, 5>& coefficients) {
  constexpr int max_iterations = 50;
  constexpr double enough = 1e-12;
  Eigen::Vector2d point = target;
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const Eigen::Vector2d residual = target - brown(point, coefficients);
    point += residual;
    if (residual.squaredNorm() < enough * enough) break;
  }
  return point;
}

void require_within(double value, double low, double high, const char* field) {
  if (value >= low && value <= high) return;  // false for NaN
  throw Error(field, fmt::format("{} is out of range for {} (allowed: {} to {})", value, field, low, high),
              "give the camera's intrinsics");
}

}  // namespace

Eigen::Vector2d Intrinsics::project(const Eigen::Vector3d& point) const {
  Eigen::Vector2d plane = point.head<2>() / point.z();
  if (distortion == Distortion::brown_conrady) plane = brown(plane, coefficients);
  if (distortion == Distortion::inverse_brown_conrady) plane = inverse_brown(plane, coefficients);
  return {fx * plane.x() + cx, fy * plane.y() + cy};
}

Eigen::Vector3d Intrinsics::deproject(const Eigen::Vector2d& pixel, double depth_m) const {
  Eigen::Vector2d plane((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  if (distortion == Distortion::brown_conrady) plane = inverse_brown(plane, coefficients);
  if (distortion == Distortion::inverse_brown_conrady) plane = brown(plane, coefficients);
  return {plane.x() * depth_m, plane.y() * depth_m, depth_m};
}

bool Intrinsics::contains(const Eigen::Vector2d& pixel) const {
  return pixel.x() >= -0.5 && pixel.x() < width - 0.5 && pixel.y() >= -0.5 && pixel.y() < height - 0.5;
}

void Intrinsics::check() const {
  // These limits admit any camera, and are narrow enough that nothing computed within them overflows.
  constexpr double max_px = 1e6;
  require_within(width, 1, max_px, "width");
  require_within(height, 1, max_px, "height");
  require_within(fx, 1e-3, max_px, "fx");
  require_within(fy, 1e-3, max_px, "fy");
  require_within(cx, -max_px, max_px, "cx");
  require_within(cy, -max_px, max_px, "cy");
  for (const double coefficient : coefficients) require_within(coefficient, -1e6, 1e6, "distortion");
}

}  // namespace rva
