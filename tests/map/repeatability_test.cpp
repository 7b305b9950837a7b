#include "map/repeatability.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "map/repeatability_summary.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"
#include "sim/simulated_robot.hpp"
#include "tests/map/painted_wall.hpp"

namespace rva {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double exact_deg = 0.003;  // 0.016 px of pictures without noise

/// A robot with errors of its own, before a painted wall.
class RepeatabilityTest : public testing::Test {
 protected:
  void use(const SimulatedRobotOptions& errors, const test::PaintedWallOptions& wall = {}) {
    robot_ = std::make_unique<SimulatedRobot>(errors, clock_.now_s, 3);
    camera_ = std::make_unique<test::PaintedWall>([this] { return robot_->true_joints(); }, wall);
  }

  Repeatability measure(Camera& camera, Robot& robot, const std::vector<PanTilt>& poses = {{0.0, -10.0}}) {
    truth_.clear();
    const auto note_truth = [this](auto, auto, auto) { truth_.push_back(robot_->true_joints()); };
    return measure_repeatability({camera, robot, clock_, chain_, base_}, poses, options_, note_truth);
  }
  Repeatability measure() { return measure(*camera_, *robot_); }

  // The largest error of any return against the robot's true joints.
  [[nodiscard]] double largest_error_deg(const Repeatability& measured) const {
    double most_deg = 0.0;
    auto truth = truth_.begin();
    for (const PoseReturns& pose : measured.poses) {
      const PanTilt first = *truth++;
      for (const MeasuredReturn& back : pose.returns) {
        most_deg = std::max({most_deg, std::abs(back.turn.pan_deg - (truth->pan_deg - first.pan_deg)),
                             std::abs(back.turn.tilt_deg - (truth->tilt_deg - first.tilt_deg))});
        ++truth;
      }
    }
    return most_deg;
  }

  Clock clock_ = unhurried_clock();
  PanTiltChain chain_;
  std::string base_;
  RepeatabilityOptions options_{.returns = 8, .frames = 1, .leave_deg = 5.0};
  std::unique_ptr<SimulatedRobot> robot_;
  std::unique_ptr<test::PaintedWall> camera_;
  std::vector<PanTilt> truth_;
};

TEST_F(RepeatabilityTest, OfARobotWithoutErrorsIsZeroWithinNoise) {
  use({.backlash_deg = 0.0}, {.noise = 1.0});
  const RepeatabilitySummary summary = summary_of(measure(), {});
  for (const JointReturns& joint : {summary.pan, summary.tilt}) {
    EXPECT_LT(joint.most_off_deg, 0.005);
    EXPECT_LT(joint.most_off_larger_deg, 0.005);
    EXPECT_LE(joint.play.low, 0.0);
    EXPECT_GE(joint.play.high, 0.0);
    EXPECT_GT(joint.noise.value, 0.0);
    EXPECT_LT(joint.deviation.low, 2.0 * joint.noise.high);
  }
  EXPECT_EQ(summary.verdict, Fitness::fit);
}

TEST_F(RepeatabilityTest, ShowsThePlayOfARobotWithoutOtherErrors) {
  for (const double play_deg : {0.1, 1.5}) {
    use({.backlash_deg = play_deg});
    const RepeatabilitySummary summary = summary_of(measure(), {});
    EXPECT_NEAR(summary.pan.play.value, play_deg, exact_deg);
    EXPECT_NEAR(summary.tilt.play.value, play_deg, exact_deg);
    EXPECT_NEAR(summary.pan.deviation.value, 0.0, exact_deg);
    EXPECT_EQ(summary.verdict, play_deg < 0.6 ? Fitness::fit : Fitness::unfit);
  }
}

TEST_F(RepeatabilityTest, EachReturnIsThatOfTheCamera) {
  for (const bool color : {false, true}) {
    use({.rest_error_deg = 0.16}, {.lamp = !color, .color = color});
    const Repeatability measured = measure(*camera_, *robot_, {{25.0, 2.0}, {-20.0, -30.0}});
    ASSERT_EQ(measured.poses.size(), 2U);
    EXPECT_LT(largest_error_deg(measured), exact_deg);
    const RepeatabilitySummary summary = summary_of(measured, {});
    EXPECT_EQ(summary.returns, 16U);
    EXPECT_GT(summary.pan.deviation.value, 0.04);
    EXPECT_LT(summary.most_rest_deg, 2.0 * exact_deg);
  }
}

TEST_F(RepeatabilityTest, ArrivesFromEitherSideInHalfOfTheReturns) {
  use({});
  int pan = 0;
  int tilt = 0;
  int both = 0;
  const Repeatability measured = measure();
  for (const MeasuredReturn& back : measured.poses.front().returns) {
    pan += back.pan == ArrivedFrom::larger ? 1 : 0;
    tilt += back.tilt == ArrivedFrom::larger ? 1 : 0;
    both += back.pan == ArrivedFrom::larger && back.tilt == ArrivedFrom::larger ? 1 : 0;
  }
  EXPECT_EQ(pan, 4);
  EXPECT_EQ(tilt, 4);
  EXPECT_EQ(both, 2);
}

TEST_F(RepeatabilityTest, OfTheSimulatedBayIsWithinAHundredthOfADegreeOfTheTruth) {
  use({.rest_error_deg = 0.16});
  SimulatedCamera camera(load_scene(RVA_SCENES "/three-tools.yaml"), {}, 4, ColorFrames::all,
                         [this] { return robot_->true_joints(); });
  EXPECT_LT(largest_error_deg(measure(camera, *robot_, {{-30.0, -35.0}})), 0.01);
}

TEST_F(RepeatabilityTest, IsRefusedWhereTheCameraDoesNotTurnWithTheRobot) {
  use({});
  test::PaintedWall standing([] { return PanTilt{}; });
  EXPECT_THAT([&] { (void)measure(standing, *robot_); },
              ThrowsMessage<Error>(HasSubstr("check that it is fixed to the robot")));
  test::PaintedWall exchanged([this] {
    const PanTilt joints = robot_->true_joints();
    return PanTilt{joints.tilt_deg, joints.pan_deg};
  });
  EXPECT_THAT(
      [&] {
        (void)measure(exchanged, *robot_, {{-5.0, -5.0}});
      },
      ThrowsMessage<Error>(HasSubstr("the servos' IDs")));
}

TEST_F(RepeatabilityTest, IsRefusedWhereTheCameraSeesTooLittle) {
  use({}, {.contrast = 0.0, .noise = 2.0});
  EXPECT_THAT([this] { (void)measure(); }, ThrowsMessage<Error>(HasSubstr("switch a steady light on")));
  EXPECT_EQ(camera_->light, Light::projector);
  use({}, {.depth = false});
  EXPECT_THAT([this] { (void)measure(); }, ThrowsMessage<Error>(HasSubstr("measures no depth")));
  use({}, {.lamp = false});
  EXPECT_THAT([this] { (void)measure(); }, ThrowsMessage<Error>(HasSubstr("no colour imager")));
}

TEST_F(RepeatabilityTest, IsRefusedWhereTheViewChanges) {
  use({});
  camera_->on_frame = [this](std::uint64_t number) {
    if (number > 30) camera_->loose = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY());
  };
  EXPECT_THAT([this] { (void)measure(); }, ThrowsMessage<Error>(HasSubstr("sees another view after return")));
}

TEST_F(RepeatabilityTest, EndsWithTheProjectorOnWhenItIsInterrupted) {
  use({});
  camera_->on_frame = [](std::uint64_t number) {
    if (number == 20) throw Interrupted(2);
  };
  EXPECT_THROW((void)measure(), Interrupted);
  EXPECT_EQ(camera_->light, Light::projector);
}

TEST_F(RepeatabilityTest, PassesOnThatTheRobotDoesNotAnswer) {
  struct Mute : Robot {
    [[nodiscard]] RobotLimits limits() const override { return {}; }
    void move_to(const PanTilt&) override { throw Error("robot", "does not answer", "switch it on"); }
    [[nodiscard]] PanTilt joints() override { return {}; }
    [[nodiscard]] bool moving() override { return false; }
    void stop() override {}
  } mute;
  use({});
  EXPECT_THAT([&] { (void)measure(*camera_, mute); }, ThrowsMessage<Error>(HasSubstr("does not answer")));
}

TEST_F(RepeatabilityTest, RefusesPosesThatItCannotLeaveInEveryDirection) {
  use({});
  for (const PanTilt& pose : {PanTilt{0.0, 6.0}, PanTilt{87.0, 0.0}, PanTilt{0.0, 20.0}})
    EXPECT_THROW((void)measure(*camera_, *robot_, {pose}), UsageError);
  EXPECT_EQ(robot_->joints(), PanTilt{});
}

TEST_F(RepeatabilityTest, RefusesOptionsOutOfRange) {
  use({});
  options_.returns = 1;
  EXPECT_THROW((void)measure(), OptionError);
  options_ = {.frames = 0};
  EXPECT_THROW((void)measure(), OptionError);
  EXPECT_THROW((void)summary_of({}, {.deviation_deg = 0.0}), OptionError);
}

TEST_F(RepeatabilityTest, IsUndecidedWhereALimitIsWithinTheInterval) {
  use({.rest_error_deg = 0.16}, {.noise = 4.0});
  const Repeatability measured = measure();
  const RepeatabilityLimits wide{.deviation_deg = 1.0, .off_deg = 1.0, .play_deg = 1.0, .noise_deg = 0.02};
  const RepeatabilitySummary usual = summary_of(measured, wide);
  EXPECT_EQ(usual.verdict, Fitness::fit);
  const auto verdict_with = [&](double RepeatabilityLimits::*limit_deg, double most_deg) {
    RepeatabilityLimits limits = wide;
    limits.*limit_deg = most_deg;
    return summary_of(measured, limits).verdict;
  };
  const double most_off_deg = std::max(usual.pan.most_off_deg, usual.tilt.most_off_deg);
  EXPECT_EQ(verdict_with(&RepeatabilityLimits::deviation_deg, 0.2), Fitness::undecided);
  EXPECT_EQ(verdict_with(&RepeatabilityLimits::deviation_deg, 0.01), Fitness::unfit);
  EXPECT_EQ(verdict_with(&RepeatabilityLimits::off_deg, most_off_deg), Fitness::undecided);
  EXPECT_EQ(verdict_with(&RepeatabilityLimits::off_deg, most_off_deg - 0.05), Fitness::unfit);
  EXPECT_EQ(verdict_with(&RepeatabilityLimits::play_deg, 0.3), Fitness::undecided);
  EXPECT_EQ(verdict_with(&RepeatabilityLimits::play_deg, 0.01), Fitness::unfit);
  EXPECT_EQ(verdict_with(&RepeatabilityLimits::noise_deg, 0.0001), Fitness::undecided);
}

TEST_F(RepeatabilityTest, DoesNotBlameTheRobotForTheNoiseOfThePictures) {
  use({.backlash_deg = 0.0}, {.noise = 10.0});
  const Repeatability measured = measure();
  const double noise_deg = summary_of(measured, {}).pan.noise.value;
  const RepeatabilitySummary summary =
      summary_of(measured, {.deviation_deg = 0.5 * noise_deg, .off_deg = 0.5 * noise_deg});
  EXPECT_EQ(summary.verdict, Fitness::undecided);
}

}  // namespace
}  // namespace rva
