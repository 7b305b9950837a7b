#include "measure/quantity.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

SurfacePoint point(const Eigen::Vector3d& position_m, const Eigen::Vector3d& deviations_mm) {
  const Eigen::Vector3d deviations_m = deviations_mm / 1000.0;
  return {position_m, deviations_m.cwiseAbs2().asDiagonal()};
}

MeasureOptions without_scale() {
  MeasureOptions options;
  options.calibration_share = 0.0;
  return options;
}

TEST(Quantity, ADistanceHasTheUncertaintyAlongTheLineOfSight) {
  const Quantity distance = distance_of(point({0, 0, 0.5}, {9, 9, 2}), without_scale());
  EXPECT_NEAR(distance.value_mm, 500.0, 1e-9);
  EXPECT_NEAR(distance.uncertainty_mm, 2.0, 1e-9);
  EXPECT_NEAR(distance.expanded_mm(), 4.0, 1e-9);
}

TEST(Quantity, ALengthHasThatOfBothEndsAlongIt) {
  const Quantity length =
      length_between(point({0, 0, 0.5}, {3, 9, 9}), point({0.1, 0, 0.5}, {4, 9, 9}), without_scale());
  EXPECT_NEAR(length.value_mm, 100.0, 1e-9);
  EXPECT_NEAR(length.uncertainty_mm, 5.0, 1e-9);
}

TEST(Quantity, TheScaleIsAShareOfTheValue) {
  MeasureOptions options;
  options.calibration_share = 0.01;
  const Quantity length =
      length_between(point({0, 0, 0.5}, {0, 0, 0}), point({0.1, 0, 0.5}, {0, 0, 0}), options);
  EXPECT_NEAR(length.uncertainty_mm, 1.0, 1e-9);
}

TEST(Quantity, PointsThatCoincideHaveNoDirectionAndTheLargestUncertainty) {
  const SurfacePoint same = point({0, 0, 0.5}, {3, 4, 1});
  const Quantity length = length_between(same, same, without_scale());
  EXPECT_EQ(length.value_mm, 0.0);
  EXPECT_NEAR(length.uncertainty_mm, std::sqrt(2.0) * 4.0, 1e-9);
}

TEST(Quantity, AHeightIsPositiveTowardsTheCamera) {
  const Plane wall{{0, 0, 2}, Eigen::Matrix3d::Zero()};
  EXPECT_NEAR(height_above(point({0.1, 0, 0.48}, {1, 1, 3}), wall, without_scale()).value_mm, 20.0, 1e-9);
  EXPECT_NEAR(height_above(point({0.1, 0, 0.48}, {1, 1, 3}), wall, without_scale()).uncertainty_mm, 3.0,
              1e-9);
  EXPECT_NEAR(height_above(point({0, 0, 0.55}, {1, 1, 3}), wall, without_scale()).value_mm, -50.0, 1e-9);
}

// The derivative by the plane's coefficients, against differences of the height itself.
TEST(Quantity, AHeightHasTheUncertaintyOfItsPlane) {
  const SurfacePoint at = point({0.05, -0.08, 0.45}, {0, 0, 0});
  const Eigen::Vector3d n(0.5, 0.3, 1.9);
  for (int axis = 0; axis < 3; ++axis) {
    const double step = 1e-4;
    const Eigen::Vector3d change = step * Eigen::Vector3d::Unit(axis);
    const double more = height_above(at, {n + change, Eigen::Matrix3d::Zero()}, without_scale()).value_mm;
    const double less = height_above(at, {n - change, Eigen::Matrix3d::Zero()}, without_scale()).value_mm;
    Plane plane{n, Eigen::Matrix3d::Zero()};
    plane.covariance(axis, axis) = step * step;
    EXPECT_NEAR(height_above(at, plane, without_scale()).uncertainty_mm, std::abs(more - less) / 2.0, 1e-6);
  }
}

}  // namespace
}  // namespace rva
