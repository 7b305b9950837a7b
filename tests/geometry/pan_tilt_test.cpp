#include "geometry/pan_tilt.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rva {
namespace {

constexpr PanTiltChain chain{};
constexpr double tolerance = 1e-12;

Eigen::Vector3d direction(const PanTilt& joints, const Eigen::Vector3d& in_camera) {
  return foot_from_camera(chain, joints).linear() * in_camera;
}

const Eigen::Vector3d right = Eigen::Vector3d::UnitX();
const Eigen::Vector3d down = Eigen::Vector3d::UnitY();
const Eigen::Vector3d ahead = Eigen::Vector3d::UnitZ();

TEST(PanTilt, AtZeroTheCameraLooksForwardAndLevel) {
  EXPECT_TRUE(direction({}, ahead).isApprox(Eigen::Vector3d::UnitY(), tolerance));
  EXPECT_TRUE(direction({}, down).isApprox(-Eigen::Vector3d::UnitZ(), tolerance));
  EXPECT_TRUE(direction({}, right).isApprox(Eigen::Vector3d::UnitX(), tolerance));
}

TEST(PanTilt, AtZeroTheLengthsAddUp) {
  const Eigen::Vector3d expected(chain.camera_right_m, chain.bracket_forward_m + chain.camera_forward_m,
                                 chain.pan_height_m + chain.bracket_height_m + chain.camera_up_m);
  EXPECT_TRUE(foot_from_camera(chain, {}).translation().isApprox(expected, tolerance));
}

TEST(PanTilt, PositivePanLooksLeft) {
  const PanTilt left{90.0, 0.0};
  EXPECT_TRUE(direction(left, ahead).isApprox(-Eigen::Vector3d::UnitX(), tolerance));
  EXPECT_TRUE(direction(left, down).isApprox(-Eigen::Vector3d::UnitZ(), tolerance));
}

TEST(PanTilt, NegativeTiltLooksDown) {
  const PanTilt to_the_ground{0.0, -90.0};
  EXPECT_TRUE(direction(to_the_ground, ahead).isApprox(-Eigen::Vector3d::UnitZ(), tolerance));
  EXPECT_TRUE(direction(to_the_ground, right).isApprox(Eigen::Vector3d::UnitX(), tolerance));
}

TEST(PanTilt, TheTiltAxisTurnsWithThePan) {
  const PanTilt left_and_up{90.0, 45.0};
  EXPECT_TRUE(
      direction(left_and_up, ahead).isApprox(Eigen::Vector3d(-1.0, 0.0, 1.0).normalized(), tolerance));
  EXPECT_NEAR(direction(left_and_up, right).z(), 0.0, tolerance);  // the horizon stays level
}

TEST(PanTilt, PanTurnsEverythingAboutTheFootsVertical) {
  const Transform before = foot_from_camera(chain, {-20.0, -35.0});
  const Transform after = foot_from_camera(chain, {10.0, -35.0});
  const Transform turn(Eigen::AngleAxisd(std::numbers::pi / 6.0, Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(after.isApprox(turn * before, tolerance));
}

TEST(PanTilt, TiltTurnsTheCameraAboutItsOwnAxis) {
  const Eigen::Vector3d axis_m(0.0, chain.bracket_forward_m, chain.pan_height_m + chain.bracket_height_m);
  const double reach_m = (foot_from_camera(chain, {}).translation() - axis_m).norm();
  for (const double tilt_deg : {-90.0, -18.0, 9.0}) {
    const Transform foot_from_tilted = foot_from_camera(chain, {0.0, tilt_deg});
    EXPECT_NEAR((foot_from_tilted.translation() - axis_m).norm(), reach_m, tolerance) << tilt_deg;
    EXPECT_NEAR(foot_from_tilted.translation().x(), chain.camera_right_m, tolerance) << tilt_deg;
  }
}

TEST(PanTilt, EveryPoseIsRigid) {
  for (double pan_deg = -90.0; pan_deg <= 90.0; pan_deg += 15.0) {
    for (double tilt_deg = -90.0; tilt_deg <= 9.0; tilt_deg += 11.0) {
      const Eigen::Matrix3d rotation = foot_from_camera(chain, {pan_deg, tilt_deg}).linear();
      EXPECT_TRUE(rotation.isUnitary(tolerance)) << pan_deg << ' ' << tilt_deg;
      EXPECT_NEAR(rotation.determinant(), 1.0, tolerance) << pan_deg << ' ' << tilt_deg;
    }
  }
}

}  // namespace
}  // namespace rva
