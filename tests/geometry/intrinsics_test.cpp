#include "geometry/intrinsics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.hpp"

namespace rva {
namespace {

Intrinsics camera(Distortion distortion) {
  return {848, 480, 425.0, 424.0, 423.5, 239.5, distortion, {-0.055, 0.064, -0.0006, 0.0004, -0.02}};
}

class EveryDistortion : public testing::TestWithParam<Distortion> {};

TEST_P(EveryDistortion, ProjectionUndoesDeprojection) {
  const Intrinsics intrinsics = camera(GetParam());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(0, 847);
  std::uniform_real_distribution<double> v(0, 479);
  std::uniform_real_distribution<double> depth_m(0.2, 4.0);
  for (int trial = 0; trial < 500; ++trial) {
    const Eigen::Vector2d pixel(u(random), v(random));
    const double z_m = depth_m(random);
    const Eigen::Vector3d point = intrinsics.deproject(pixel, z_m);
    EXPECT_EQ(point.z(), z_m);
    EXPECT_NEAR((intrinsics.project(point) - pixel).norm(), 0.0, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EveryDistortion,
                         testing::Values(Distortion::none, Distortion::brown_conrady,
                                         Distortion::inverse_brown_conrady));

TEST(Intrinsics, AxesRunRightDownForward) {
  const Intrinsics intrinsics = camera(Distortion::none);
  EXPECT_EQ(intrinsics.project({0, 0, 1}), Eigen::Vector2d(423.5, 239.5));
  EXPECT_GT(intrinsics.project({0.1, 0, 1}).x(), 423.5);
  EXPECT_GT(intrinsics.project({0, 0.1, 1}).y(), 239.5);
}

// The first pixel's centre is (0, 0), so the image's corner is half a pixel beyond it.
TEST(Intrinsics, FirstPixelHasItsCentreAtZero) {
  const Intrinsics intrinsics{3, 2, 1.0, 1.0, 1.0, 0.5};
  const Eigen::Vector2d corner = intrinsics.project({-1.5, -1.0, 1.0});
  EXPECT_EQ(corner, Eigen::Vector2d(-0.5, -0.5));
  EXPECT_TRUE(intrinsics.contains(corner));
  EXPECT_TRUE(intrinsics.contains({2.49, 1.49}));
  EXPECT_FALSE(intrinsics.contains({2.5, 0}));
  EXPECT_FALSE(intrinsics.contains({0, 1.5}));
  EXPECT_FALSE(intrinsics.contains({-0.51, 0}));
}

TEST(Intrinsics, BrownConradyBendsByItsPolynomial) {
  Intrinsics intrinsics{100, 100, 100.0, 100.0, 50.0, 50.0, Distortion::brown_conrady, {0.1, 0, 0, 0, 0}};
  // At x = 0.5, r^2 = 0.25: x (1 + 0.1 * 0.25) = 0.5125.
  EXPECT_NEAR(intrinsics.project({0.5, 0, 1}).x(), 50.0 + 51.25, 1e-12);
  intrinsics.distortion = Distortion::inverse_brown_conrady;
  EXPECT_NEAR(intrinsics.deproject({100.0, 50.0}, 1.0).x(), 0.5125, 1e-12);
}

TEST(Intrinsics, RefusesWhatIsNoCamera) {
  const auto refused = [](auto change) {
    Intrinsics bad = camera(Distortion::none);
    EXPECT_NO_THROW(bad.check());
    change(bad);
    EXPECT_THROW(bad.check(), Error);
  };
  refused([](Intrinsics& bad) { bad.width = 0; });
  refused([](Intrinsics& bad) { bad.height = -1; });
  refused([](Intrinsics& bad) { bad.fx = 0.0; });
  refused([](Intrinsics& bad) { bad.fx = 1e-308; });
  refused([](Intrinsics& bad) { bad.cy = 1e308; });
  refused([](Intrinsics& bad) { bad.fy = std::nan(""); });
  refused([](Intrinsics& bad) { bad.cx = HUGE_VAL; });
  refused([](Intrinsics& bad) { bad.coefficients[2] = std::nan(""); });
}

TEST(Distortion, NamesAreTheirOwnInverse) {
  for (const Distortion model :
       {Distortion::none, Distortion::brown_conrady, Distortion::inverse_brown_conrady}) {
    EXPECT_EQ(value_of<Distortion>(name_of(model)), model);
  }
  EXPECT_FALSE(value_of<Distortion>("fisheye"));
}

}  // namespace
}  // namespace rva
