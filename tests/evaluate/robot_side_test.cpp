#include "evaluate/robot_side.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "evaluate/moved_wing.hpp"
#include "robot/dither.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

double off_a_step(double angle_deg) {
  return std::abs(angle_deg - servo_step_deg * std::round(angle_deg / servo_step_deg));
}

TEST(RobotSide, CapturesStateWholeStepsAndTheJointsRestBesideThem) {
  const test::TemporaryFolder folder;
  const Scene scene = random_moved_wing(7, CameraReturn::rest).before;
  const RobotSideOptions resting{.captures = 2, .frames = 1, .rest_error_deg = half_a_step_deg};
  const RobotSide side = take_by_robot(scene, {}, resting, 3, folder / "a");
  const RobotSide again = take_by_robot(scene, {}, resting, 3, folder / "b");
  const RobotSide other = take_by_robot(scene, {}, resting, 4, folder / "c");
  ASSERT_EQ(side.captures.size(), 2U);
  ASSERT_EQ(side.rested.size(), 2U);
  const Captures captures = side.open(2);
  for (std::size_t k = 0; k < 2; ++k) {
    const Pose pose = captures[k]->info().pose.value();
    EXPECT_LT(off_a_step(*pose.pan_deg), 1e-9) << "what it reports";
    EXPECT_LT(std::abs(*pose.pan_deg - side.rested[k].pan_deg), half_a_step_deg);
    EXPECT_LT(std::abs(*pose.tilt_deg - side.rested[k].tilt_deg), half_a_step_deg);
    EXPECT_GT(off_a_step(side.rested[k].tilt_deg), 1e-6) << "where it is";
    EXPECT_EQ(side.rested[k].pan_deg, again.rested[k].pan_deg);
    EXPECT_NE(side.rested[k].pan_deg, other.rested[k].pan_deg);
  }
  EXPECT_EQ(captures[1]->depth(0), again.open(2)[1]->depth(0));
}

TEST(RobotSide, ARobotWithoutErrorComesBackExactly) {
  const test::TemporaryFolder folder;
  const Scene scene = random_moved_wing(7, CameraReturn::exact).before;
  const RobotSide side = take_by_robot(scene, {}, {.captures = 1, .frames = 1}, 3, folder / "a");
  const RobotSide later = take_by_robot(scene, {}, {.captures = 1, .frames = 1}, 4, folder / "b");
  EXPECT_EQ(side.rested[0].pan_deg, later.rested[0].pan_deg);
  EXPECT_EQ(side.rested[0].tilt_deg, later.rested[0].tilt_deg);
  EXPECT_LT(off_a_step(side.rested[0].tilt_deg), 1e-9);
  EXPECT_EQ(side.open(1)[0]->info().pose->base, scene.stand.base);
}

}  // namespace
}  // namespace rva
