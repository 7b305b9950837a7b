#include "views/registration_starts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/random.hpp"
#include "tests/views/box_room.hpp"

namespace rva {
namespace {

using test::error_of;
using test::pose;

TEST(RegistrationStarts, IncludeTheGuess) {
  const Transform guess = pose(0.1, 0.2, 5);
  int same = 0;
  for (const Transform& start : starts_around(guess))
    same += error_of(start, guess).mm < 1e-6 && error_of(start, guess).deg < 1e-6 ? 1 : 0;
  EXPECT_GT(same, 0);
}

// The limits of a coarse registration's convergence that the spacing is made for: half a pitch of the grid
// sideways, along the view and in turn, and what a tilt that differs by 10 degrees adds to each.
TEST(RegistrationStarts, ReachEveryPlaceToWhichACameraIsPutBack) {
  const std::vector<Transform> starts = starts_around(Transform::Identity());
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const double tilt_deg = random.uniform(0.0, 40.0);
    const double turn_deg = random.uniform(-20.0, 20.0);
    const double distance_m = 0.5 * std::sqrt(random.uniform());
    const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
    const Transform moved =
        pose(distance_m * std::cos(direction), distance_m * std::sin(direction), turn_deg, tilt_deg);
    const Transform truth = pose(0, 0, 0, tilt_deg).inverse() * moved;
    const bool reached = std::ranges::any_of(starts, [&](const Transform& start) {
      return error_of(start, truth).mm < 240.0 && error_of(start, truth).deg < 5.5;
    });
    EXPECT_TRUE(reached) << distance_m << " m, turned by " << turn_deg << ", tilted by " << tilt_deg;
  }
}

TEST(RegistrationStarts, AreInTheFinalCamerasFrameOfTheGuess) {
  const Transform guess = pose(-0.2, 0.1, -12, 25);
  const std::vector<Transform> around = starts_around(guess);
  const std::vector<Transform> around_nothing = starts_around(Transform::Identity());
  ASSERT_EQ(around.size(), around_nothing.size());
  for (std::size_t i = 0; i < around.size(); ++i)
    EXPECT_TRUE(around[i].isApprox(guess * around_nothing[i], 1e-12)) << i;
}

TEST(RegistrationStarts, AreRigidAndLieOnBothSidesAlike) {
  const std::vector<Transform> starts = starts_around(Transform::Identity());
  Eigen::Vector3d sideways = Eigen::Vector3d::Zero();
  for (const Transform& start : starts) {
    EXPECT_TRUE((start.linear() * start.linear().transpose()).isIdentity(1e-12));
    EXPECT_NEAR(start.linear().determinant(), 1.0, 1e-12);
    sideways += start.translation();
  }
  EXPECT_NEAR(sideways.norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace rva
