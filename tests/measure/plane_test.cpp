#include "measure/plane.hpp"

#include <gtest/gtest.h>

#include "measure/quantity.hpp"
#include "tests/measure/known_view.hpp"

namespace rva {
namespace {

using test::plane;
using test::rectangle;
using test::view_of;

const Eigen::Vector3d slanted(0.7, -0.5, 2.1);

SurfacePoint exact(const Eigen::Vector3d& ray) {
  return {ray / slanted.dot(ray), 1e-8 * Eigen::Matrix3d::Identity()};
}

TEST(Plane, PassesThroughItsThreePoints) {
  const std::array corners{exact({0, 0, 1}), exact({0.2, 0, 1}), exact({0, 0.2, 1})};
  const auto through = std::get<Plane>(plane_through(corners));
  EXPECT_NEAR((through.coefficients_per_m - slanted).norm(), 0.0, 1e-9);
}

// By random displacements of the three points.
TEST(Plane, OfThreePointsHasTheCovarianceOfTheirErrors) {
  const std::array corners{exact({0, 0, 1}), exact({0.2, 0, 1}), exact({0, 0.2, 1})};
  const auto through = std::get<Plane>(plane_through(corners));
  Random random(3);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  constexpr int trials = 4000;
  for (int trial = 0; trial < trials; ++trial) {
    auto moved = corners;
    for (SurfacePoint& corner : moved)
      corner.position_m += 1e-4 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    const Eigen::Vector3d off = std::get<Plane>(plane_through(moved)).coefficients_per_m - slanted;
    sum += off * off.transpose() / trials;
  }
  EXPECT_NEAR((sum - through.covariance).norm() / through.covariance.norm(), 0.0, 0.08);
}

TEST(Plane, PointsInALineSpanNone) {
  const std::array line{exact({0, 0, 1}), exact({0.1, 0, 1}), exact({0.2, 0, 1})};
  EXPECT_EQ(std::get<Unmeasured>(plane_through(line)), Unmeasured::collinear);
  const SurfacePoint same = exact({0, 0, 1});
  EXPECT_EQ(std::get<Unmeasured>(plane_through({same, same, same})), Unmeasured::collinear);
}

TEST(Plane, ThroughTheCameraIsRefused) {
  const auto at = [](double x, double y, double z) { return SurfacePoint{{x, y, z}, {}}; };
  EXPECT_EQ(std::get<Unmeasured>(plane_through({at(0, 0, 0.5), at(0.2, 0, 0.5), at(0.1, 0, 1)})),
            Unmeasured::collinear);
}

TEST(Plane, OfARegionIgnoresAnObjectOnIt) {
  const UncertainView view = view_of([](const Eigen::Vector3d& ray) {
    const double depth_m = 1.0 / slanted.dot(ray);
    return std::abs(ray.x()) < 0.06 && std::abs(ray.y()) < 0.06 ? depth_m - 0.03 : depth_m;
  });
  const auto fitted = std::get<Plane>(plane_in(view, rectangle(40, 30, 80, 60)));
  EXPECT_NEAR((fitted.coefficients_per_m - slanted).norm(), 0.0, 1e-4);
}

TEST(Plane, OfTheWholeViewIsThinnedAndExact) {
  const UncertainView view = view_of(plane(slanted));
  const auto fitted = std::get<Plane>(plane_in(view, rectangle(0, 0, test::view_width, test::view_height)));
  EXPECT_NEAR((fitted.coefficients_per_m - slanted).norm(), 0.0, 1e-5);
}

TEST(Plane, RegionsThatDetermineNoneAreRefused) {
  UncertainView view = view_of(plane(slanted));
  EXPECT_EQ(std::get<Unmeasured>(plane_in(view, rectangle(0, 0, 0, 0))), Unmeasured::outside);
  EXPECT_EQ(std::get<Unmeasured>(plane_in(view, rectangle(10, 10, 3, 3))), Unmeasured::missing_depth);
  EXPECT_EQ(std::get<Unmeasured>(plane_in(view, rectangle(10, 10, 40, 1))), Unmeasured::collinear);
  view.disparity_px = Image<float>(test::view_width, test::view_height);
  EXPECT_EQ(std::get<Unmeasured>(plane_in(view, rectangle(10, 10, 40, 40))), Unmeasured::missing_depth);
}

}  // namespace
}  // namespace rva
