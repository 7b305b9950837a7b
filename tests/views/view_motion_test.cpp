#include "views/view_motion.hpp"

#include <gtest/gtest.h>

#include "tests/views/shots.hpp"
#include "views/view_check.hpp"

namespace rva {
namespace {

using test::bay;
using test::littered;
using test::view_of;

constexpr double noise_px = 0.05;

Transform turned(double right_deg, double down_deg = 15.0) {
  return test::pose(0.12, 0.0, right_deg, down_deg);
}

ViewMotion motion(const test::Room& before, const Transform& from, const test::Room& after,
                  const Transform& to, std::uint64_t seed = 1) {
  return view_motion(view_of(before, from, {noise_px, 0.0, 2 * seed}),
                     view_of(after, to, {noise_px, 0.04, 2 * seed + 1}));
}

TEST(ViewMotion, NothingIsNoticedOfACameraThatStoodStill) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_FALSE(motion(bay(), turned(-5), bay(), turned(-5), seed).noticed());
    EXPECT_FALSE(motion(bay(), turned(-5), littered(), turned(-5), seed).noticed()) << "debris is no motion";
  }
}

TEST(ViewMotion, ATenthOfADegreeIsNoticed) {
  for (const double turn_deg : {0.1, 0.16, 0.325, 1.0}) {
    for (const double sign : {-1.0, 1.0}) {
      EXPECT_TRUE(motion(bay(), turned(-5), bay(), turned(-5 + sign * turn_deg)).noticed()) << turn_deg;
      EXPECT_TRUE(motion(bay(), turned(-5), bay(), turned(-5, 15 + sign * turn_deg)).noticed()) << turn_deg;
      EXPECT_TRUE(motion(bay(), turned(-5), littered(), turned(-5 + sign * turn_deg)).noticed()) << turn_deg;
    }
  }
}

// Beyond what is linear: registration decides.
TEST(ViewCheck, ThreeDegreesAreNoticedToo) {
  for (const Transform& to : {turned(-2), turned(-8), turned(-5, 18), turned(-5, 12)}) {
    const ViewCheck check =
        check_views(view_of(bay(), turned(-5), {noise_px, 0.0, 5}), view_of(bay(), to, {noise_px, 0.04, 6}));
    EXPECT_FALSE(check.is_aligned());
  }
}

TEST(ViewCheck, ALargeObjectIsNoMotion) {
  test::Room room = bay();
  room.boxes.push_back(test::box(-0.15, 0.25, 0.0, 0.25, 0.6, 0.75));
  EXPECT_TRUE(check_views(view_of(bay(), turned(-5), {noise_px, 0.0, 7}),
                          view_of(room, turned(-5), {noise_px, 0.04, 8}))
                  .is_aligned());
}

TEST(ViewMotion, IsMeasuredWhereItIsSmall) {
  const ViewMotion seen = motion(bay(), turned(-5), bay(), turned(-5 + 0.3));
  const double expected_px = 0.3 * std::numbers::pi / 180.0 * test::small_camera().fx;
  EXPECT_NEAR(seen.displacement_px, expected_px, 0.4 * expected_px);
  EXPECT_LT(seen.uncertainty_px, 0.2 * expected_px);
}

TEST(ViewMotion, AWallDoesNotConstrainMotionAlongIt) {
  const test::Room wall{{test::box(-9, 9, -9, 9, 1.0, 1.1)}};
  EXPECT_FALSE(motion(wall, test::pose(0, 0, 0, 0), wall, test::pose(0.01, 0, 0, 0)).noticed());
}

// An object on a bare table that was exchanged for another one: only there does anything change.
TEST(ViewMotion, OneObjectThatChangedIsNoMotion) {
  test::Room table{{test::box(-9, 9, -9, 9, 1.0, 1.1), test::box(-0.1, 0.05, -0.1, 0.1, 0.95, 1.0)}};
  test::Room other{{test::box(-9, 9, -9, 9, 1.0, 1.1), test::box(-0.02, 0.12, -0.05, 0.12, 0.96, 1.0)}};
  const Transform above = test::pose(0, 0, 0, 0);
  EXPECT_FALSE(motion(table, above, other, above).noticed());
  EXPECT_FALSE(motion(other, above, table, above).noticed());
}

TEST(ViewMotion, OtherBaysDiffer) {
  test::Room other = bay();
  for (test::Box3& solid : other.boxes) solid.translate(Eigen::Vector3d(0.0, 0.15, 0.3));
  EXPECT_GT(motion(bay(), turned(-5), other, turned(-5)).differing, 0.5);
}

}  // namespace
}  // namespace rva
