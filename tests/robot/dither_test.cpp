#include "robot/dither.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "tests/manual_clock.hpp"

namespace rva {
namespace {

TEST(Dither, OffsetsAreWholeServoStepsAllDifferentTheFirstNone) {
  std::set<std::pair<double, double>> seen;
  const std::vector<PanTilt> offsets = dither_offsets(most_dithers);
  EXPECT_EQ(offsets.front(), PanTilt{});
  for (const PanTilt& offset : offsets) {
    for (const double deg : {offset.pan_deg, offset.tilt_deg}) {
      EXPECT_NEAR(std::remainder(deg, servo_step_deg), 0.0, 1e-9);
      EXPECT_GE(deg, 0.0);
      EXPECT_LE(deg, 2.6);
    }
    EXPECT_TRUE(seen.emplace(offset.pan_deg, offset.tilt_deg).second);
  }
  EXPECT_EQ(dither_offsets(4).size(), 4U);
  EXPECT_EQ(dither_offsets(4).back(), offsets[3]) << "more captures keep the offsets of fewer";
}

// Spread over the square: each quarter of it has its share.
TEST(Dither, AnyPowerOfTwoOfThemFillsTheSquare) {
  for (const int count : {4, 8, 16}) {
    int quarters[2][2] = {};
    for (const PanTilt& offset : dither_offsets(count))
      ++quarters[offset.pan_deg > 3.5 * servo_step_deg][offset.tilt_deg > 3.5 * servo_step_deg];
    for (const auto& row : quarters) {
      for (const int here : row) EXPECT_EQ(here, count / 4) << count;
    }
  }
}

/// Arrives at once, and remembers where it was sent.
class QuickRobot : public Robot {
 public:
  [[nodiscard]] RobotLimits limits() const override { return {}; }
  void move_to(const PanTilt& target) override {
    limits().check(target);
    visited.push_back(target);
  }
  [[nodiscard]] PanTilt joints() override { return visited.back(); }
  [[nodiscard]] bool moving() override { return false; }
  void stop() override {}

  std::vector<PanTilt> visited;
};

TEST(Approach, ComesFromBelowInBothJoints) {
  test::ManualClock clock;
  QuickRobot robot;
  EXPECT_EQ(approach(robot, {10.0, -20.0}, clock.clock()), (PanTilt{10.0, -20.0}));
  ASSERT_EQ(robot.visited.size(), 2U);
  EXPECT_LT(robot.visited[0].pan_deg, 10.0 - 0.3);
  EXPECT_LT(robot.visited[0].tilt_deg, -20.0 - 0.3);
  EXPECT_EQ(approach(robot, {-90.0, -90.0}, clock.clock()), (PanTilt{-90.0, -90.0})) << "the end of the way";
}

}  // namespace
}  // namespace rva
