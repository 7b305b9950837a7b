#include "measure/surface_point.hpp"

#include <gtest/gtest.h>

#include "tests/measure/known_view.hpp"

namespace rva {
namespace {

using test::plane;
using test::view_of;

SurfacePoint point_at(const UncertainView& view, const Eigen::Vector2d& pixel) {
  return std::get<SurfacePoint>(surface_point(view, pixel, {}));
}

TEST(SurfacePoint, LiesOnASlantedPlaneAlsoBetweenPixels) {
  const Eigen::Vector3d n(0.6, -0.4, 2.0);
  const UncertainView view = view_of(plane(n));
  const Eigen::Vector2d pixel(33.37, 80.81);
  const SurfacePoint point = point_at(view, pixel);
  EXPECT_NEAR(n.dot(point.position_m), 1.0, 1e-6);
  EXPECT_NEAR((view.camera.project(point.position_m) - pixel).norm(), 0.0, 1e-6);
}

// A wall that faces the camera, at the principal point: depth by equation 2 with the window's correlation,
// sideways by the pixel.
TEST(SurfacePoint, CovarianceOfAWallIsThatOfItsClosedForm) {
  const UncertainView view = view_of(plane({0, 0, 2}));
  const Eigen::Matrix3d covariance = point_at(view, {79.5, 59.5}).covariance_m2;
  const UncertainView shifted = view_of(plane({0, 0, 2}));
  // The middle of a window of 5 x 5 at (80, 60): the mean of all its pixels, nearly, half a pixel off.
  double mean_correlation = 0.0;
  for (int a = 0; a < 5; ++a) {
    for (int b = 0; b < 5; ++b) mean_correlation += shifted.correlation(a - b, 0) / 25.0;
  }
  const double depth_variance_m2 =
      std::pow(0.5 * 0.5 / view.stereo.focal_baseline_m_px * 0.06 * mean_correlation, 2);
  EXPECT_NEAR(covariance(2, 2) / depth_variance_m2, 1.0, 0.1);
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), 0.5 * 0.5 / 200.0, 1e-6);
  EXPECT_NEAR(covariance(0, 2), 0.0, 1e-9);
}

TEST(SurfacePoint, AFewWrongMatchesDoNotMoveIt) {
  UncertainView view = view_of(plane({0, 0, 2}));
  const SurfacePoint before = point_at(view, {50, 50});
  view.disparity_px(49, 50) = 35.0F;
  view.disparity_px(52, 52) = 3.0F;
  EXPECT_NEAR((point_at(view, {50, 50}).position_m - before.position_m).norm(), 0.0, 1e-9);
}

TEST(SurfacePoint, AtAnEdgeItIsOfTheSurfaceInTheMiddle) {
  const UncertainView view = view_of([](const Eigen::Vector3d& ray) { return ray.x() < 0.0 ? 0.5 : 0.8; });
  EXPECT_NEAR(point_at(view, {78, 60}).position_m.z(), 0.5, 1e-6);
  EXPECT_NEAR(point_at(view, {81, 60}).position_m.z(), 0.8, 1e-6);
}

Unmeasured reason_at(const UncertainView& view, const Eigen::Vector2d& pixel) {
  return std::get<Unmeasured>(surface_point(view, pixel, {}));
}

TEST(SurfacePoint, RefusalsStateTheReason) {
  UncertainView view = view_of(plane({0, 0, 2}));
  EXPECT_EQ(reason_at(view, {-0.6, 60}), Unmeasured::outside);
  EXPECT_EQ(reason_at(view, {1e300, 60}), Unmeasured::outside);
  EXPECT_EQ(reason_at(view, {std::nan(""), 60}), Unmeasured::outside);
  for (int v = 40; v < 60; ++v) {
    for (int u = 40; u < 60; ++u) view.disparity_px(u, v) = 0.0F;
  }
  EXPECT_EQ(reason_at(view, {50, 50}), Unmeasured::missing_depth);
  // Every pixel has a disparity of its own.
  for (int v = 80; v < 100; ++v) {
    for (int u = 80; u < 100; ++u)
      view.disparity_px(u, v) = static_cast<float>(5 + 3 * (u % 5) + 20 * (v % 5));
  }
  EXPECT_EQ(reason_at(view, {90, 90}), Unmeasured::edge);
  EXPECT_TRUE(std::holds_alternative<SurfacePoint>(surface_point(view, {0, 0}, {})))
      << "the corner has its few neighbours";
}

TEST(SurfacePoint, ScatterBeyondTheStatedUncertaintyIsAddedToIt) {
  UncertainView view = view_of(plane({0, 0, 2}));
  const double before = point_at(view, {50, 50}).covariance_m2(2, 2);
  for (int v = 45; v < 56; ++v) {
    for (int u = 45; u < 56; ++u) view.disparity_px(u, v) += (u + v) % 2 == 0 ? 0.3F : -0.3F;
  }
  EXPECT_GT(point_at(view, {50, 50}).covariance_m2(2, 2), 10.0 * before);
}

}  // namespace
}  // namespace rva
