#include "map/joint_turn.hpp"

#include <gtest/gtest.h>

#include "core/units.hpp"
#include "map/dot_free_pictures.hpp"
#include "tests/map/painted_wall.hpp"

namespace rva {
namespace {

constexpr double exact_deg = 0.003;  // 0.016 px: rounding and interpolation

/// A gauge at a pose, and pictures of other poses.
class JointTurnTest : public testing::TestWithParam<bool> {
 protected:
  [[nodiscard]] test::PaintedWallOptions wall() const { return {.lamp = !GetParam(), .color = GetParam()}; }

  [[nodiscard]] JointTurnGauge gauge_at(const PanTilt& pose, DotFreePictures& pictures) {
    joints_ = pose;
    const ReferenceSurface surface = pictures.surface(1);
    return {PanTiltChain{}, pose, pictures.imager(), surface, pictures.take(1)};
  }
  [[nodiscard]] JointTurn turn_by(double pan_deg, double tilt_deg, const PanTilt& pose,
                                  const test::PaintedWallOptions& options) {
    test::PaintedWall camera([this] { return joints_; }, options);
    DotFreePictures pictures(camera);
    const JointTurnGauge gauge = gauge_at(pose, pictures);
    joints_ = {pose.pan_deg + pan_deg, pose.tilt_deg + tilt_deg};
    return gauge.turn_to(pictures.take(1));
  }

  PanTilt joints_;
};

TEST_P(JointTurnTest, IsThatOfTheRobotAtAnyPose) {
  for (const PanTilt& pose : {PanTilt{0.0, 0.0}, PanTilt{20.0, -30.0}, PanTilt{-35.0, 8.0}}) {
    for (const PanTilt& turn :
         {PanTilt{0.0, 0.0}, PanTilt{0.05, -0.1}, PanTilt{-0.4, 0.3}, PanTilt{1.9, 1.9}}) {
      const JointTurn seen = turn_by(turn.pan_deg, turn.tilt_deg, pose, wall());
      EXPECT_NEAR(seen.pan_deg, turn.pan_deg, exact_deg);
      EXPECT_NEAR(seen.tilt_deg, turn.tilt_deg, exact_deg);
      EXPECT_NEAR(seen.rest_deg, 0.0, exact_deg);
      EXPECT_GT(seen.correlation, 0.99);
    }
  }
}

TEST_P(JointTurnTest, ScattersWithNoiseButIsNotMadeSmallerByIt) {
  constexpr int trials = 12;
  double sum_deg = 0.0;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    test::PaintedWallOptions options = wall();
    options.noise = 5.0;
    options.seed = seed;
    const JointTurn seen = turn_by(0.3, 0.3, {}, options);
    EXPECT_NEAR(seen.pan_deg, 0.3, 0.01);
    EXPECT_NEAR(seen.tilt_deg, 0.3, 0.01);
    sum_deg += seen.pan_deg + seen.tilt_deg;
  }
  EXPECT_NEAR(sum_deg / (2.0 * trials), 0.3, 0.002);
}

TEST_P(JointTurnTest, DoesNotAgreeWhereNothingIsSeen) {
  test::PaintedWallOptions options = wall();
  options.contrast = 0.0;
  options.noise = 3.0;
  EXPECT_LT(turn_by(0.0, 0.0, {}, options).correlation, least_correlation);
}

INSTANTIATE_TEST_SUITE_P(ByImager, JointTurnTest, testing::Values(false, true),
                         [](const auto& tested) { return tested.param ? "color" : "infrared"; });

TEST(JointTurnGauge, IgnoresHowBrightThePictureIs) {
  PanTilt joints;
  test::PaintedWall camera([&] { return joints; });
  DotFreePictures pictures(camera);
  const ReferenceSurface surface = pictures.surface(1);
  const JointTurnGauge gauge(PanTiltChain{}, joints, pictures.imager(), surface, pictures.take(1));
  joints = {0.2, -0.1};
  Image<float> brighter = pictures.take(1);
  for (float& brightness : brighter.pixels()) brightness = 1.3F * brightness + 2.0F;
  const JointTurn seen = gauge.turn_to(brighter);
  EXPECT_NEAR(seen.pan_deg, 0.2, exact_deg);
  EXPECT_NEAR(seen.tilt_deg, -0.1, exact_deg);
}

TEST(JointTurnGauge, ShowsATurnThatNoJointMakes) {
  constexpr double roll_deg = 0.3;
  test::PaintedWall camera([] { return PanTilt{}; });
  DotFreePictures pictures(camera);
  const ReferenceSurface surface = pictures.surface(1);
  const JointTurnGauge gauge(PanTiltChain{}, {}, pictures.imager(), surface, pictures.take(1));
  camera.loose = Eigen::AngleAxisd(radians(roll_deg), Eigen::Vector3d::UnitZ());
  const JointTurn seen = gauge.turn_to(pictures.take(1));
  EXPECT_NEAR(seen.rest_deg, roll_deg, exact_deg);
  EXPECT_NEAR(seen.pan_deg, 0.0, exact_deg);
  EXPECT_NEAR(seen.tilt_deg, 0.0, exact_deg);
}

}  // namespace
}  // namespace rva
