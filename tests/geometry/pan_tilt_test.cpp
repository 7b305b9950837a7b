#include "geometry/pan_tilt.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rva {
namespace {

const PanTiltChain chain;
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
  const Eigen::Vector3d expected =
      chain.servo1.at_m + chain.bracket.at_m + chain.bracket_from_camera.translation();
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
  const Eigen::Vector3d axis_m = chain.servo1.at_m + chain.bracket.at_m;
  const double reach_m = (foot_from_camera(chain, {}).translation() - axis_m).norm();
  for (const double tilt_deg : {-90.0, -18.0, 9.0}) {
    const Transform foot_from_tilted = foot_from_camera(chain, {0.0, tilt_deg});
    EXPECT_NEAR((foot_from_tilted.translation() - axis_m).norm(), reach_m, tolerance) << tilt_deg;
    EXPECT_NEAR(foot_from_tilted.translation().x(), chain.bracket_from_camera.translation().x(), tolerance)
        << tilt_deg;
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

// A robot that was bent: nothing is along an axis of the foot.
PanTiltChain bent() {
  PanTiltChain bent;
  bent.servo1 = {{0.01, -0.02, 0.17}, Eigen::Vector3d(0.03, -0.02, 1.0).normalized()};
  bent.bracket = {{0.004, 0.006, 0.061}, Eigen::Vector3d(1.0, 0.02, -0.04).normalized()};
  bent.bracket_from_camera.rotate(Eigen::AngleAxisd(0.05, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()));
  return bent;
}

TEST(PanTilt, IsTheProductOfRotationsAboutAxesThatAreNotAtTheOrigin) {
  const PanTilt joints{33.0, -21.0};
  // Equation 2.2 by hand: a rotation about a point is a shift there, a rotation, and a shift back.
  const auto about = [](const JointAxis& joint, double angle_deg) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180.0, joint.axis).toRotationMatrix();
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = turn;
    matrix.topRightCorner<3, 1>() = joint.at_m;
    return matrix;
  };
  const Eigen::Matrix4d expected = about(bent().servo1, joints.pan_deg) *
                                   about(bent().bracket, joints.tilt_deg) *
                                   bent().bracket_from_camera.matrix();
  EXPECT_TRUE(foot_from_camera(bent(), joints).matrix().isApprox(expected, tolerance));
}

TEST(PanTilt, TwistsAreTheVelocitiesOfTheCamera) {
  constexpr double small_deg = 1e-4;
  constexpr double small_rad = small_deg * std::numbers::pi / 180.0;
  const PanTilt joints{-40.0, -25.0};
  const JointTwists twists = joint_twists(bent(), joints);
  const auto velocity = [&](const PanTilt& turned) {
    const Transform between = foot_from_camera(bent(), joints).inverse() * foot_from_camera(bent(), turned);
    const Eigen::AngleAxisd turn(between.linear());
    Eigen::Matrix<double, 6, 1> result;
    result << turn.angle() * turn.axis(), between.translation();
    return Eigen::Matrix<double, 6, 1>(result / small_rad);
  };
  EXPECT_LT((velocity({joints.pan_deg + small_deg, joints.tilt_deg}) - twists.pan).norm(), 1e-5);
  EXPECT_LT((velocity({joints.pan_deg, joints.tilt_deg + small_deg}) - twists.tilt).norm(), 1e-5);
}

}  // namespace
}  // namespace rva
