#include "measure/quantity.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/units.hpp"

namespace rva {
namespace {

Quantity quantity(double value_m, double variance_m2, const MeasureOptions& options) {
  const double scale_m = options.calibration_share * value_m;
  return {mm_per_m * value_m, mm_per_m * std::sqrt(variance_m2 + scale_m * scale_m)};
}

double variance_along(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& direction) {
  return direction.dot(covariance * direction);
}

}  // namespace

Quantity distance_of(const SurfacePoint& point, const MeasureOptions& options) {
  return quantity(point.position_m.norm(), variance_along(point.covariance_m2, point.position_m.normalized()),
                  options);
}

Quantity length_between(const SurfacePoint& a, const SurfacePoint& b, const MeasureOptions& options) {
  const Eigen::Vector3d apart_m = b.position_m - a.position_m;
  const Eigen::Matrix3d covariance_m2 = a.covariance_m2 + b.covariance_m2;
  const double length_m = apart_m.norm();
  if (length_m > 0.0) return quantity(length_m, variance_along(covariance_m2, apart_m / length_m), options);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> directions(covariance_m2);
  return quantity(0.0, directions.eigenvalues().maxCoeff(), options);
}

Quantity height_above(const SurfacePoint& point, const Plane& plane, const MeasureOptions& options) {
  const Eigen::Vector3d& n = plane.coefficients_per_m;
  const double size = n.norm();
  const double height_m = (1.0 - n.dot(point.position_m)) / size;
  const Eigen::Vector3d by_plane = -point.position_m / size - height_m / (size * size) * n;
  return quantity(height_m,
                  variance_along(point.covariance_m2, n / size) + variance_along(plane.covariance, by_plane),
                  options);
}

}  // namespace rva
