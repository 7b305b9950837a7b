#include "robot/drive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <limits>
#include <mutex>
#include <thread>

#include "core/error.hpp"

namespace rva {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

/// Is at its target at once, and records the commands.
class ObedientRobot : public Robot {
 public:
  [[nodiscard]] RobotLimits limits() const override { return {}; }
  void move_to(const PanTilt& target) override {
    const std::lock_guard lock(mutex_);
    if (broken_) throw Error("robot", "is jammed", "free it");
    limits().check(target);
    joints_ = target;
    ++moves_;
  }
  [[nodiscard]] PanTilt joints() override {
    const std::lock_guard lock(mutex_);
    return joints_;
  }
  [[nodiscard]] bool moving() override { return false; }
  void stop() override {
    const std::lock_guard lock(mutex_);
    if (deaf_) throw Error("robot", "does not hear", "check its cable");
    ++stops_;
  }

  [[nodiscard]] int moves() const { return read(moves_); }
  [[nodiscard]] int stops() const { return read(stops_); }
  void set_broken(bool broken) {
    const std::lock_guard lock(mutex_);
    broken_ = broken;
  }
  void set_deaf(bool deaf) {
    const std::lock_guard lock(mutex_);
    deaf_ = deaf;
  }

 private:
  int read(const int& number) const {
    const std::lock_guard lock(mutex_);
    return number;
  }
  mutable std::mutex mutex_;
  PanTilt joints_;
  int moves_ = 0;
  int stops_ = 0;
  bool broken_ = false;
  bool deaf_ = false;
};

class Driving : public testing::Test {
 protected:
  // Says so again and again, as a console does, until the condition holds.
  template <typename Condition>
  bool hold_until(const Deflection& deflection, const Condition& holds) {
    return eventually([&] {
      drive_.steer(deflection);
      return holds();
    });
  }
  template <typename Condition>
  static bool eventually(const Condition& holds) {
    for (int i = 0; i < 1000; ++i) {
      if (holds()) return true;
      std::this_thread::sleep_for(milliseconds(10));
    }
    return false;
  }

  ObedientRobot robot_;
  Drive drive_{robot_, {.speed_deg_s = 60.0, .silence_ms = 150}};
};

TEST_F(Driving, HeldSticksTurnTheJointsTheirWay) {
  EXPECT_TRUE(hold_until({0.5, -1.0}, [&] { return robot_.joints().tilt_deg < -10.0; }));
  const PanTilt joints = robot_.joints();
  EXPECT_GT(joints.pan_deg, 0.0);
  EXPECT_NEAR(joints.pan_deg, -0.5 * joints.tilt_deg, 1e-9) << "half the deflection, half the way";
}

// A worn stick rests beside its middle.
TEST_F(Driving, ATinyDeflectionIsLettingGo) {
  ASSERT_TRUE(hold_until({1.0, 0.0}, [&] { return robot_.moves() > 2; }));
  drive_.halt();
  ASSERT_TRUE(eventually([&] { return robot_.stops() >= 1 && !drive_.state().armed; }));
  const PanTilt rest = robot_.joints();
  EXPECT_TRUE(hold_until({-0.0035, 0.0}, [&] { return drive_.state().armed; }))
      << "the stop can be left again";
  for (int i = 0; i < 20; ++i) {
    drive_.steer({-0.0035, 0.01});
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_EQ(robot_.joints().pan_deg, rest.pan_deg) << "nothing creeps";
  EXPECT_TRUE(hold_until({0.5, 0.0}, [&] { return robot_.joints().pan_deg > rest.pan_deg + 1.0; }));
}

TEST_F(Driving, LettingGoStops) {
  ASSERT_TRUE(hold_until({1.0, 0.0}, [&] { return robot_.moves() > 2; }));
  drive_.steer({});
  EXPECT_TRUE(eventually([&] { return robot_.stops() == 1 && !drive_.state().driving; }));
}

TEST_F(Driving, SilenceStopsAndOnlyNeutralSticksGoOn) {
  ASSERT_TRUE(hold_until({1.0, 0.0}, [&] { return robot_.moves() > 2; }));
  ASSERT_TRUE(eventually([&] { return robot_.stops() == 1; })) << "nobody said anything more";
  EXPECT_FALSE(drive_.state().armed);
  const int moves = robot_.moves();
  for (int i = 0; i < 20; ++i) {
    drive_.steer({1.0, 0.0});
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_EQ(robot_.moves(), moves) << "sticks that were held all the while have no effect";
  drive_.steer({});
  EXPECT_TRUE(hold_until({1.0, 0.0}, [&] { return robot_.moves() > moves; }));
}

TEST_F(Driving, HaltStopsEveryMovementAndDisarms) {
  ASSERT_TRUE(hold_until({0.0, -1.0}, [&] { return robot_.moves() > 2; }));
  drive_.halt();
  EXPECT_TRUE(eventually([&] { return robot_.stops() == 1; }));
  drive_.steer({0.0, -1.0});
  EXPECT_FALSE(drive_.state().armed);
  const Drive::Loan loan(drive_);
  drive_.halt();
  EXPECT_TRUE(eventually([&] { return robot_.stops() == 2; })) << "a capture is stopped, too";
}

TEST_F(Driving, SticksHaveNoEffectWhileTheRobotIsLent) {
  const Drive::Loan loan(drive_);
  for (int i = 0; i < 20; ++i) {
    drive_.steer({1.0, 0.0});
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_EQ(robot_.moves(), 0);
  EXPECT_TRUE(drive_.state().lent);
}

TEST_F(Driving, EndsAtTheSoftLimits) {
  EXPECT_TRUE(hold_until({0.0, 1.0}, [&] { return drive_.state().at_limit; }));
  EXPECT_EQ(robot_.joints().tilt_deg, RobotLimits{}.tilt.max_deg);
}

TEST_F(Driving, WhatIsNoNumberOrTooMuchIsNoMotionOrFullMotion) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(hold_until({nan, -1e300}, [&] { return robot_.joints().tilt_deg < -5.0; }));
  EXPECT_EQ(robot_.joints().pan_deg, 0.0);
}

TEST_F(Driving, ARobotThatRefusesIsSaidAndDisarms) {
  robot_.set_broken(true);
  EXPECT_TRUE(hold_until({1.0, 0.0}, [&] { return !drive_.state().problem.empty(); }));
  EXPECT_THAT(drive_.state().problem, HasSubstr("jammed"));
  EXPECT_TRUE(eventually([&] { return !drive_.state().armed; }));
}

TEST_F(Driving, ALoanBeginsWithACommandToStop) {
  ASSERT_TRUE(hold_until({1.0, 0.0}, [&] { return drive_.state().driving; }));
  const Drive::Loan loan(drive_);
  EXPECT_FALSE(drive_.state().driving);
  const int stops = robot_.stops();
  EXPECT_GE(stops, 1);
  std::this_thread::sleep_for(milliseconds(200));
  EXPECT_EQ(robot_.stops(), stops) << "what the capture moves is not stopped by a stick that was held before";
}

TEST_F(Driving, AStopThatTheRobotDidNotTakeIsSaidAgain) {
  robot_.set_deaf(true);
  drive_.halt();
  ASSERT_TRUE(eventually([&] { return drive_.state().problem.find("does not hear") != std::string::npos; }));
  EXPECT_EQ(robot_.stops(), 0);
  robot_.set_deaf(false);
  EXPECT_TRUE(eventually([&] { return robot_.stops() == 1; }));
}

TEST(Drive, StopsWhatItDroveWhenItEnds) {
  ObedientRobot robot;
  {
    Drive drive(robot);
    for (int i = 0; i < 1000 && robot.moves() == 0; ++i) {
      drive.steer({1.0, 0.0});
      std::this_thread::sleep_for(milliseconds(5));
    }
    ASSERT_GT(robot.moves(), 0);
  }
  EXPECT_EQ(robot.stops(), 1);
}

TEST(Drive, RefusesOptionsOutOfRange) {
  ObedientRobot robot;
  EXPECT_THROW(Drive(robot, {.speed_deg_s = 500.0}), UsageError);
  EXPECT_THROW(Drive(robot, {.silence_ms = 5000}), UsageError) << "half a second is the most";
}

}  // namespace
}  // namespace rva
