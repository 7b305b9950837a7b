#include "views/free_space.hpp"

#include <gtest/gtest.h>

#include "geometry/stereo_scale.hpp"
#include "tests/views/box_room.hpp"

namespace rva {
namespace {

using test::bay;
using test::pose;
using test::view_of;

const Transform before = pose(0.12, 0.0, -5);
const Transform after = pose(-0.1, 0.02, 4);

struct Counts {
  int nearer = 0;
  int farther = 0;
  int judged = 0;
};

Counts count(const DisparityChange& change) {
  constexpr float clear_px = 0.5F;
  Counts counts;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (change.judged[i] == 0) continue;
    ++counts.judged;
    counts.nearer += change.change_px(i) > clear_px ? 1 : 0;
    counts.farther += change.change_px(i) < -clear_px ? 1 : 0;
  }
  return counts;
}

DisparityChange compare(const test::Room& initial, const test::Room& final, double offset_px = 0.0) {
  return free_space_change(view_of(initial, before, {0.0, offset_px, 1}), view_of(final, after),
                           before.inverse() * after, offset_px);
}

TEST(FreeSpace, NothingChangedAndNewlyVisibleAreaIsNoChange) {
  const DisparityChange change = compare(bay(), bay());
  const Counts counts = count(change);
  EXPECT_GT(counts.judged, 0.5 * static_cast<double>(change.judged.size()));
  EXPECT_EQ(counts.nearer, 0);
  EXPECT_EQ(counts.farther, 0);
  int unseen = 0;
  for (std::size_t i = 0; i < change.judged.size(); ++i)
    unseen += change.after_px[i] > 0.0F && change.before_px[i] <= 0.0F ? 1 : 0;
  EXPECT_GT(unseen, 1000) << "the other side of the bay comes into view";
}

TEST(FreeSpace, AThingThatCameIsNearerAndOneThatWentFarther) {
  test::Room with = bay();
  with.boxes.push_back(test::box(-0.05, 0.05, 0.19, 0.25, 0.65, 0.72));
  const Counts came = count(compare(bay(), with));
  EXPECT_GT(came.nearer, 200);
  EXPECT_EQ(came.farther, 0);
  const Counts went = count(compare(with, bay()));
  EXPECT_GT(went.farther, 200);
  EXPECT_EQ(went.nearer, 0);
}

TEST(FreeSpace, HeightsAreInTheFinalCamerasDisparity) {
  test::Room with = bay();
  with.boxes.push_back(test::box(-0.1, 0.1, 0.0, 0.1, 1.0, 1.2));  // before the far wall
  const DisparityChange change = compare(bay(), with);
  const Eigen::Vector3d face = after.inverse() * Eigen::Vector3d(0.0, 0.05, 1.0);
  const Eigen::Vector2d pixel = test::small_camera().project(face);
  const auto u = static_cast<int>(std::lround(pixel.x()));
  const auto v = static_cast<int>(std::lround(pixel.y()));
  const double wall_px =
      test::small_camera().fx * test::baseline_m / test::depth_at(bay(), after, test::small_camera(), u, v);
  ASSERT_NE(change.judged(u, v), 0);
  EXPECT_NEAR(change.before_px(u, v), wall_px, 0.15);
}

TEST(FreeSpace, HeightsAreTrueWhereTheCameraCameCloser) {
  const Transform far_off = pose(0.0, 0.0, 0.0);
  const Transform close_up = pose(0.0, 0.25, 0.0);
  test::Room with = bay();
  with.boxes.push_back(test::box(-0.1, 0.1, 0.0, 0.1, 1.0, 1.2));  // before the far wall
  const DisparityChange change =
      free_space_change(view_of(bay(), far_off), view_of(with, close_up), far_off.inverse() * close_up, 0.0);
  const Eigen::Vector2d pixel =
      test::small_camera().project(close_up.inverse() * Eigen::Vector3d(0.0, 0.05, 1.0));
  const auto u = static_cast<int>(std::lround(pixel.x()));
  const auto v = static_cast<int>(std::lround(pixel.y()));
  ASSERT_NE(change.judged(u, v), 0);
  const StereoScale stereo{.focal_baseline_m_px = test::small_camera().fx * test::baseline_m};
  const double height_m = stereo.depth_m(static_cast<double>(change.before_px(u, v))) -
                          stereo.depth_m(static_cast<double>(change.after_px(u, v)));
  const double true_m = test::depth_at(bay(), close_up, test::small_camera(), u, v) -
                        test::depth_at(with, close_up, test::small_camera(), u, v);
  EXPECT_NEAR(height_m, true_m, 0.03 * true_m);
}

TEST(FreeSpace, RemovesTheDriftOfTheCamera) {
  const Counts counts = count(compare(bay(), bay(), 1.0));
  EXPECT_EQ(counts.nearer, 0);
  EXPECT_EQ(counts.farther, 0);
}

TEST(FreeSpace, WhatStandsBeforeWhatWasHiddenIsUnseen) {
  // A post hides a part of the wall from the first pose; from the second one, that part is in view.
  test::Room post = bay();
  post.boxes.push_back(test::box(-0.06, 0.06, -0.5, 0.25, 0.5, 0.55));
  const Counts counts = count(compare(post, post));
  EXPECT_EQ(counts.nearer, 0);
  EXPECT_EQ(counts.farther, 0);
}

TEST(FreeSpace, WhatStandsWhereTheFirstViewWasBlindIsUnseen) {
  // The first view has no depth on a post, but beside it on the wall that the post stands before in the
  // second.
  test::Room post = bay();
  post.boxes.push_back(test::box(-0.02, 0.02, -0.5, 0.25, 0.5, 0.55));
  DepthView initial = view_of(post, before);
  const DepthView without = view_of(bay(), before);
  std::size_t blind = 0;
  for (std::size_t i = 0; i < initial.disparity_px.size(); ++i) {
    if (std::abs(initial.disparity_px[i] - without.disparity_px[i]) < 1.0F) continue;
    initial.disparity_px[i] = 0.0F;
    ++blind;
  }
  ASSERT_GT(blind, 500U);
  const Counts counts =
      count(free_space_change(initial, view_of(post, after), before.inverse() * after, 0.0));
  EXPECT_EQ(counts.nearer, 0);
}

}  // namespace
}  // namespace rva
