#include "map/pose_return.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "evaluate/moved_wing.hpp"
#include "evaluate/robot_side.hpp"
#include "tests/temporary_folder.hpp"
#include "views/baseline_poses.hpp"

namespace rva {
namespace {

constexpr PoseReturnOptions six{.approaches = 6, .within_deg = 0.05};

TEST(PoseReturn, EndsAsSoonAsAnApproachIsWithinTheLimit) {
  EXPECT_TRUE(is_close_enough({0.05}, six));
  EXPECT_FALSE(is_close_enough({0.051}, six));
  EXPECT_TRUE(is_close_enough({0.2, 0.01}, six));
}

TEST(PoseReturn, FromHalfOfTheApproachesOnTakesWhatIsAsCloseAsAnyBefore) {
  EXPECT_FALSE(is_close_enough({0.3, 0.2}, six)) << "closer ones are likely among four more";
  EXPECT_TRUE(is_close_enough({0.3, 0.2, 0.1}, six));
  EXPECT_FALSE(is_close_enough({0.1, 0.2, 0.3}, six));
  EXPECT_FALSE(is_close_enough({0.1, 0.2, 0.3, 0.2, 0.2}, six));
  EXPECT_TRUE(is_close_enough({0.1, 0.2, 0.3, 0.2, 0.2, 0.2}, six)) << "the last of all";
}

TEST(PoseReturn, OneApproachIsAlwaysTheLast) { EXPECT_TRUE(is_close_enough({5.0}, PoseReturnOptions{})); }

/// A bay with a robot that comes to rest anywhere within half a step.
class ReturnInABay : public testing::Test {
 protected:
  [[nodiscard]] RobotSide take(const char* name, std::uint64_t seed, std::optional<Baseline> baseline) const {
    return take_by_robot(
        random_moved_wing(7, CameraReturn::rest).before, {},
        {.captures = 4, .frames = 4, .rest_error_deg = half_a_step_deg, .baseline = std::move(baseline)},
        seed, folder_ / name);
  }
  // Mean over the captures of how far they are from the baseline's poses in truth.
  static double off_deg(const RobotSide& before, const RobotSide& after) {
    double sum = 0.0;
    for (std::size_t k = 0; k < after.rested.size(); ++k)
      sum += std::hypot(after.rested[k].pan_deg - before.rested[k].pan_deg,
                        after.rested[k].tilt_deg - before.rested[k].tilt_deg);
    return sum / static_cast<double>(after.rested.size());
  }

  test::TemporaryFolder folder_;
};

TEST_F(ReturnInABay, ComesCloserByApproachingAgainAndStatesHowClose) {
  const RobotSide before = take("before", 1, {});
  const RobotSide once = take("once", 2, {});
  const RobotSide again =
      take("again", 2, Baseline{folder_ / "before", 4, {.approaches = 8, .within_deg = 0.05}});
  EXPECT_LT(off_deg(before, again), 0.9 * off_deg(before, once));
  for (const auto& capture : again.open(4)) {
    const Pose pose = capture->info().pose.value();
    EXPECT_GE(pose.approaches.value(), 1);
    EXPECT_LE(pose.approaches.value(), 8);
    EXPECT_LT(pose.off_baseline_deg.value(), 0.45) << "as far as two rests can be apart";
  }
  EXPECT_FALSE(once.open(1)[0]->info().pose->approaches) << "nothing was approached again";
}

TEST_F(ReturnInABay, TheTurnOfACaptureIsSmallFromItselfAndLargeFromItsNeighbours) {
  const Captures captures = take("before", 1, {}).open(4);
  BaselinePoses poses(captures);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT(poses.turn_deg(k, *captures[k]).value(), 0.02);
    EXPECT_GT(poses.turn_deg(k, *captures[(k + 1) % 4]).value(), half_a_step_deg);
  }
}

TEST_F(ReturnInABay, DepthAloneShowsATurnWithoutInfraredImages) {
  const RobotSide side = take("before", 1, {});
  for (const auto& capture : side.captures) std::filesystem::remove_all(capture / "infrared");
  const Captures captures = side.open(4);
  ASSERT_FALSE(captures[0]->has_infrared(Imager::left, Light::projector));
  BaselinePoses poses(captures);
  EXPECT_LT(poses.turn_deg(0, *captures[0]).value_or(0.0), 0.02);
  EXPECT_GT(poses.turn_deg(0, *captures[1]).value(), half_a_step_deg);
}

}  // namespace
}  // namespace rva
