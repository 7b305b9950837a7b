#include "robot/robot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "tests/manual_clock.hpp"

namespace rva {
namespace {

using testing::HasSubstr;

TEST(RobotLimits, HoldBothEnds) {
  const RobotLimits limits;
  for (const double pan_deg : {-90.0, 0.0, 90.0}) {
    for (const double tilt_deg : {-90.0, 0.0, 9.0}) EXPECT_NO_THROW(limits.check({pan_deg, tilt_deg}));
  }
}

TEST(RobotLimits, NameTheAxisAndItsEnds) {
  const auto complaint = [](const PanTilt& target) -> std::string {
    try {
      RobotLimits{}.check(target);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(complaint({90.1, 0.0}), testing::AllOf(HasSubstr("pan"), HasSubstr("-90 to 90 deg")));
  EXPECT_THAT(complaint({-90.1, 0.0}), HasSubstr("pan"));
  EXPECT_THAT(complaint({0.0, 9.5}), testing::AllOf(HasSubstr("tilt"), HasSubstr("-90 to 9 deg")));
  EXPECT_THAT(complaint({0.0, -91.0}), HasSubstr("tilt"));
  EXPECT_THAT(complaint({std::nan(""), 0.0}), HasSubstr("pan"));
  EXPECT_THAT(complaint({0.0, std::numeric_limits<double>::infinity()}), HasSubstr("tilt"));
}

/// Takes a number of polls to arrive, not exactly at its target.
class SlowRobot : public Robot {
 public:
  SlowRobot(int polls, const PanTilt& arrives_off) : polls_(polls), arrives_off_(arrives_off) {}
  [[nodiscard]] RobotLimits limits() const override { return {}; }
  void move_to(const PanTilt& target) override {
    limits().check(target);
    joints_ = {target.pan_deg + arrives_off_.pan_deg, target.tilt_deg + arrives_off_.tilt_deg};
    left_ = polls_;
  }
  [[nodiscard]] PanTilt joints() override { return joints_; }
  [[nodiscard]] bool moving() override { return left_-- > 0; }
  void stop() override { stopped = true; }

  bool stopped = false;

 private:
  int polls_;
  PanTilt arrives_off_;
  PanTilt joints_;
  int left_ = 0;
};

class MoveAndWait : public testing::Test {
 protected:
  test::ManualClock clock_;
};

TEST_F(MoveAndWait, ReturnsWhatTheServosSayAtRest) {
  SlowRobot robot(50, {0.1, -0.2});
  EXPECT_EQ(move_and_wait(robot, {10.0, -20.0}, clock_.clock()), (PanTilt{10.1, -20.2}));
  EXPECT_FALSE(robot.stopped);
}

TEST_F(MoveAndWait, IsAtOnceDoneWhereNothingMoves) {
  SlowRobot robot(0, {});
  const double start_s = clock_.now_s;
  EXPECT_EQ(move_and_wait(robot, {}, clock_.clock()), PanTilt{});
  EXPECT_EQ(clock_.now_s, start_s);
}

TEST_F(MoveAndWait, StopsARobotThatTakesTooLong) {
  SlowRobot robot(1000000, {});
  const double start_s = clock_.now_s;
  EXPECT_THROW(move_and_wait(robot, {10.0, 0.0}, clock_.clock(), 5.0), Error);
  EXPECT_TRUE(robot.stopped);
  EXPECT_NEAR(clock_.now_s - start_s, 5.0, 0.1);
}

TEST_F(MoveAndWait, SaysWhenTheRobotRestsElsewhere) {
  for (const PanTilt& off : {PanTilt{3.0, 0.0}, {0.0, -3.0}, {std::nan(""), 0.0}, {0.0, std::nan("")}}) {
    SlowRobot robot(2, off);
    EXPECT_THROW(move_and_wait(robot, {10.0, 0.0}, clock_.clock()), Error);
  }
}

TEST_F(MoveAndWait, RefusesWhatIsOutOfReachAndMovesNothing) {
  SlowRobot robot(2, {});
  EXPECT_THROW(move_and_wait(robot, {0.0, 10.0}, clock_.clock()), UsageError);
  EXPECT_EQ(robot.joints(), PanTilt{});
}

}  // namespace
}  // namespace rva
