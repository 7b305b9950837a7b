#include "views/registration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/views/box_room.hpp"

namespace rva {
namespace {

using test::bay;
using test::error_of;
using test::pose;
using test::view_of;

// Poses that robots were put back to: to either side, nearer, farther, turned.
struct Move {
  Transform from;
  Transform to;
};
std::vector<Move> moves() {
  return {{pose(0.15, 0.0, -6), pose(-0.15, 0.0, 5)},
          {pose(0.0, 0.0, 0), pose(0.25, 0.1, -15)},
          {pose(0.1, 0.0, -8), pose(0.05, -0.3, 2)},
          {pose(-0.2, 0.1, 10, 20), pose(0.1, 0.0, -4, 14)},
          {pose(0.0, 0.0, 0), pose(0.001, 0.0, 0.3)}};
}

TEST(Registration, FindsWhereTheCameraWasPut) {
  std::uint64_t seed = 1;
  for (const Move& move : moves()) {
    const Transform truth = move.from.inverse() * move.to;
    const Registration found = register_views(view_of(bay(), move.from, {0.1, 0.0, seed}),
                                              view_of(bay(), move.to, {0.1, 0.0, seed + 1}));
    EXPECT_TRUE(found.trusted()) << found.doubt;
    EXPECT_LT(error_of(found.initial_from_final, truth).mm, 3.0);
    EXPECT_LT(error_of(found.initial_from_final, truth).deg, 0.25);
    EXPECT_GT(found.agreeing, 0.7);
  }
}

TEST(Registration, OfSwappedViewsIsTheInverse) {
  const Move move = moves()[0];
  const DepthView a = view_of(bay(), move.from, {0.1, 0.0, 11});
  const DepthView b = view_of(bay(), move.to, {0.1, 0.0, 12});
  const Transform there = register_views(a, b).initial_from_final;
  const Transform back = register_views(b, a).initial_from_final;
  EXPECT_LT(error_of(there * back, Transform::Identity()).mm, 2.0);
}

TEST(Registration, IsNotLedAstrayByDebrisAndByDrift) {
  const Move move = moves()[0];
  test::Room littered = bay();
  littered.boxes.push_back(test::box(-0.2, 0.0, 0.10, 0.25, 0.62, 0.75));
  littered.boxes.push_back(test::box(0.1, 0.3, 0.15, 0.25, 0.86, 0.95));
  const Registration found =
      register_views(view_of(bay(), move.from, {0.1, 0.1, 21}), view_of(littered, move.to, {0.1, 0.0, 22}));
  EXPECT_TRUE(found.trusted()) << found.doubt;
  EXPECT_LT(error_of(found.initial_from_final, move.from.inverse() * move.to).mm, 6.0);
  EXPECT_NEAR(found.offset_px, 0.1, 0.05);
}

TEST(Registration, TakesViewsOfDifferentCameras) {
  const Move move = moves()[1];
  Intrinsics other = test::small_camera();
  other.width = 640;
  other.height = 360;
  other.fx = other.fy = 300.0;
  other.cx = 330.0;
  other.cy = 170.0;
  const Registration found = register_views(view_of(bay(), move.from, {0.1, 0.0, 31}),
                                            view_of(bay(), move.to, {0.1, 0.0, 32}, other));
  EXPECT_TRUE(found.trusted()) << found.doubt;
  EXPECT_LT(error_of(found.initial_from_final, move.from.inverse() * move.to).mm, 3.0);
}

TEST(Registration, NamesWhatABareWallLeavesFree) {
  const test::Room wall{{test::box(-9, 9, -9, 9, 1.0, 1.1)}};
  const Registration found = register_views(view_of(wall, pose(0, 0, 0, 0), {0.1, 0.0, 41}),
                                            view_of(wall, pose(0.1, 0, 3, 0), {0.1, 0.0, 42}));
  EXPECT_FALSE(found.trusted());
  EXPECT_THAT(found.doubt, testing::HasSubstr("nothing in view constrains"));
}

TEST(Registration, DoesNotTrustViewsOfDifferentBays) {
  const test::Room elsewhere{
      {test::box(-0.3, 0.2, -0.5, 0.5, 0.6, 0.7), test::box(-2, 2, 0.4, 0.5, 0.3, 2.0)}};
  EXPECT_FALSE(register_views(view_of(bay(), pose(0, 0, 0), {0.1, 0.0, 51}),
                              view_of(elsewhere, pose(0, 0, 0), {0.1, 0.0, 52}))
                   .trusted());
  const DepthView nothing = view_of({}, pose(0, 0, 0));
  EXPECT_FALSE(register_views(view_of(bay(), pose(0, 0, 0)), nothing).trusted());
  EXPECT_FALSE(register_views(nothing, nothing).trusted());
}

TEST(Registration, StaysNearTheGuessOnRequest) {
  const Move move = moves()[0];
  const Transform truth = move.from.inverse() * move.to;
  Transform near = truth;
  near.translate(Eigen::Vector3d(0.01, -0.005, 0.01));
  const Registration found = register_views(view_of(bay(), move.from, {0.1, 0.0, 61}),
                                            view_of(bay(), move.to, {0.1, 0.0, 62}), {near, true});
  EXPECT_TRUE(found.trusted()) << found.doubt;
  EXPECT_LT(error_of(found.initial_from_final, truth).mm, 3.0);
  const Registration astray =
      register_views(view_of(bay(), move.from, {0.1, 0.0, 63}), view_of(bay(), move.to, {0.1, 0.0, 64}),
                     {Transform::Identity(), true});
  EXPECT_TRUE(!astray.trusted() || error_of(astray.initial_from_final, truth).mm < 3.0);
}

}  // namespace
}  // namespace rva
