#include "sim/simulated_robot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "tests/manual_clock.hpp"

namespace rva {
namespace {

constexpr double step_deg = 0.325;

class Simulated : public testing::Test {
 protected:
  SimulatedRobot robot(const SimulatedRobotOptions& options = {}) {
    return SimulatedRobot(options, clock_.clock().now_s);
  }
  void arrive(SimulatedRobot& robot, const PanTilt& target) {
    robot.move_to(target);
    clock_.now_s += 100.0;
  }
  test::ManualClock clock_;
};

constexpr SimulatedRobotOptions ideal{.backlash_deg = 0.0, .resolution_deg = 0.0};

TEST_F(Simulated, RestsAtZeroAtFirst) {
  SimulatedRobot robot = this->robot();
  EXPECT_FALSE(robot.moving());
  EXPECT_EQ(robot.joints(), PanTilt{});
  EXPECT_EQ(robot.true_joints(), PanTilt{});
}

TEST_F(Simulated, TurnsAtConstantSpeedEachJointByItself) {
  SimulatedRobot robot = this->robot(ideal);
  robot.move_to({45.0, -90.0});
  clock_.now_s += 0.25;
  EXPECT_TRUE(robot.moving());
  EXPECT_NEAR(robot.joints().pan_deg, 22.5, 1e-9);
  EXPECT_NEAR(robot.joints().tilt_deg, -22.5, 1e-9);
  clock_.now_s += 0.25 + 1e-9;
  EXPECT_TRUE(robot.moving());
  EXPECT_EQ(robot.joints().pan_deg, 45.0);
  clock_.now_s += 0.5;
  EXPECT_FALSE(robot.moving());
  EXPECT_EQ(robot.joints(), (PanTilt{45.0, -90.0}));
}

TEST_F(Simulated, MovesTheSameHoweverOftenItIsAsked) {
  SimulatedRobot seldom = this->robot();
  SimulatedRobot often = this->robot();
  for (const double pan_deg : {30.0, -12.0, 5.0}) {
    seldom.move_to({pan_deg, -pan_deg / 5.0});
    often.move_to({pan_deg, -pan_deg / 5.0});
    for (int k = 0; k < 137; ++k) {
      clock_.now_s += 0.001;
      static_cast<void>(often.moving());
    }
    EXPECT_NEAR(often.true_joints().pan_deg, seldom.true_joints().pan_deg, 1e-9);
    EXPECT_NEAR(often.true_joints().tilt_deg, seldom.true_joints().tilt_deg, 1e-9);
  }
}

TEST_F(Simulated, RestsOnTheNearestStepWithinReach) {
  SimulatedRobot robot = this->robot();
  for (double pan_deg = -90.0; pan_deg <= 90.0; pan_deg += 0.7) {
    arrive(robot, {pan_deg, -45.0});
    const double steps = robot.joints().pan_deg / step_deg;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    EXPECT_LE(std::abs(robot.joints().pan_deg - pan_deg),
              std::abs(pan_deg) < 89.5 ? step_deg / 2 + 1e-9 : step_deg);
  }
  for (const PanTilt& end : {PanTilt{90.0, 9.0}, {-90.0, -90.0}}) {
    arrive(robot, end);
    EXPECT_NO_THROW(robot.limits().check(robot.joints()));
    EXPECT_FALSE(robot.moving());
  }
}

TEST_F(Simulated, ReportsWholeStepsWhileItMoves) {
  SimulatedRobot robot = this->robot();
  robot.move_to({80.0, -80.0});
  for (int k = 0; k < 50; ++k) {
    clock_.now_s += 0.017;
    const double steps = robot.joints().tilt_deg / step_deg;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
  }
}

TEST_F(Simulated, ArrivingFromBelowLeavesNoError) {
  SimulatedRobot robot = this->robot();
  for (const double pan_deg : {-60.0, 0.0, 31.0, 85.0}) {
    arrive(robot, {pan_deg - 5.0, 0.0});
    arrive(robot, {pan_deg, 0.0});
    EXPECT_NEAR(robot.true_joints().pan_deg, robot.joints().pan_deg, 1e-9);
  }
}

TEST_F(Simulated, ArrivingFromAboveLeavesThePlay) {
  SimulatedRobot robot = this->robot({.backlash_deg = 0.5});
  for (const double tilt_deg : {-10.0, -40.0, -85.0}) {
    arrive(robot, {0.0, tilt_deg});
    EXPECT_NEAR(robot.true_joints().tilt_deg, robot.joints().tilt_deg + 0.5, 1e-9);
  }
}

TEST_F(Simulated, NothingMovesUntilThePlayIsUsedUp) {
  SimulatedRobot robot = this->robot({.backlash_deg = 0.5, .resolution_deg = 0.0});
  arrive(robot, {10.0, 0.0});
  for (const double pan_deg : {9.8, 9.6, 9.9, 9.5}) {
    arrive(robot, {pan_deg, 0.0});
    EXPECT_NEAR(robot.true_joints().pan_deg, 10.0, 1e-9);
  }
  arrive(robot, {9.4, 0.0});
  EXPECT_NEAR(robot.true_joints().pan_deg, 9.9, 1e-9);
}

TEST_F(Simulated, TheCameraIsNeverFartherThanThePlay) {
  SimulatedRobot robot = this->robot();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> pan_deg(-90.0, 90.0);
  std::uniform_real_distribution<double> pause_s(0.0, 1.0);
  for (int k = 0; k < 1000; ++k) {
    robot.move_to({pan_deg(random), 0.0});
    clock_.now_s += pause_s(random);
    const double off_deg = robot.true_joints().pan_deg - robot.joints().pan_deg;
    EXPECT_GE(off_deg, -step_deg / 2 - 1e-9);
    EXPECT_LE(off_deg, 0.3 + step_deg / 2 + 1e-9);
  }
}

TEST_F(Simulated, StopHoldsTheJointsWhereTheyAre) {
  SimulatedRobot robot = this->robot(ideal);
  robot.move_to({90.0, 0.0});
  clock_.now_s += 0.5;
  robot.stop();
  EXPECT_FALSE(robot.moving());
  clock_.now_s += 10.0;
  EXPECT_NEAR(robot.joints().pan_deg, 45.0, 1e-9);
}

TEST_F(Simulated, ANewTargetReplacesTheOldOneOnTheWay) {
  SimulatedRobot robot = this->robot(ideal);
  robot.move_to({90.0, 0.0});
  clock_.now_s += 0.5;
  robot.move_to({-45.0, 0.0});
  clock_.now_s += 0.5;
  EXPECT_NEAR(robot.joints().pan_deg, 0.0, 1e-9);
}

TEST_F(Simulated, WhatIsOutOfReachMovesNothing) {
  SimulatedRobot robot = this->robot(ideal);
  robot.move_to({20.0, 0.0});
  EXPECT_THROW(robot.move_to({0.0, 9.1}), UsageError);
  EXPECT_THROW(robot.move_to({std::nan(""), 0.0}), UsageError);
  clock_.now_s += 1.0;
  EXPECT_EQ(robot.joints(), (PanTilt{20.0, 0.0}));
}

TEST_F(Simulated, AClockThatGoesBackMovesNothing) {
  SimulatedRobot robot = this->robot(ideal);
  robot.move_to({90.0, 0.0});
  clock_.now_s -= 5.0;
  EXPECT_EQ(robot.joints(), PanTilt{});
  EXPECT_TRUE(robot.moving());
}

TEST_F(Simulated, EveryTargetIsAnArrivalForMoveAndWait) {
  SimulatedRobot robot = this->robot({.resolution_deg = 1.0});
  for (const PanTilt& target : {PanTilt{90.0, 9.0}, {-90.0, -90.0}, {33.3, -0.2}})
    EXPECT_NO_THROW(move_and_wait(robot, target, clock_.clock()));
}

TEST_F(Simulated, ItsLampHasTheBrightnessThatWasSet) {
  SimulatedRobot robot = this->robot();
  EXPECT_EQ(robot.lamp(), LampState{});
  robot.set_lamp(40);
  EXPECT_EQ(robot.lamp()->percent, 40);
  for (const int percent : {-1, 101}) EXPECT_THROW(robot.set_lamp(percent), UsageError);
  EXPECT_EQ(robot.lamp()->percent, 40);
}

TEST_F(Simulated, RefusesImpossibleOptions) {
  EXPECT_THROW(robot({.speed_deg_s = 0.0}), UsageError);
  EXPECT_THROW(robot({.backlash_deg = -0.1}), UsageError);
  EXPECT_THROW(robot({.resolution_deg = std::nan("")}), UsageError);
}

TEST(SimulatedRobotThreads, MayCommandAndAskAtTheSameTime) {
  SimulatedRobot robot;
  std::vector<std::jthread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&robot, k] {
      for (int n = 0; n < 500; ++n) {
        robot.move_to({20.0 * k, -10.0 * k});
        EXPECT_NO_THROW(robot.limits().check(robot.joints()));
        if (n % 10 == 0) robot.stop();
      }
    });
  }
}

TEST_F(Simulated, RestsNearTheStepThatItReports) {
  SimulatedRobotOptions options;
  options.rest_error_deg = 0.16;
  SimulatedRobot robot = this->robot(options);
  SimulatedRobot same = this->robot(options);
  double least_deg = 1.0;
  double most_deg = -1.0;
  for (int k = 0; k < 200; ++k) {
    arrive(robot, {step_deg * k, 0.0});  // always from below
    same.move_to({step_deg * k, 0.0});
    EXPECT_FALSE(robot.moving());
    EXPECT_NEAR(robot.joints().pan_deg, step_deg * k, 1e-9);
    const double error_deg = robot.true_joints().pan_deg - step_deg * k;
    least_deg = std::min(least_deg, error_deg);
    most_deg = std::max(most_deg, error_deg);
  }
  EXPECT_GE(least_deg, -0.16);
  EXPECT_LT(least_deg, -0.14);
  EXPECT_LE(most_deg, 0.16);
  EXPECT_GT(most_deg, 0.14);
  clock_.now_s += 100.0;
  EXPECT_EQ(robot.true_joints(), same.true_joints());
}

TEST_F(Simulated, RestsWithinItsLimits) {
  SimulatedRobotOptions options;
  options.rest_error_deg = 0.16;
  SimulatedRobot robot = this->robot(options);
  for (int k = 0; k < 50; ++k) {
    arrive(robot, {0.0, 0.0});
    arrive(robot, {90.0, 9.0});
    EXPECT_LE(robot.joints().pan_deg, 90.0);
    EXPECT_LE(robot.joints().tilt_deg, 9.0);
  }
}

}  // namespace
}  // namespace rva
