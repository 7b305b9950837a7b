#include "stereo/space_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/stereo/dithered_pairs.hpp"

namespace rva {
namespace {

constexpr double speckle = 0.12;

// Where every view sees the surface and the window is whole: the left border has no partner in the right
// image.
constexpr int left_px = 60;
constexpr int border_px = 20;

template <typename Use>
void for_each_judged(Use use) {
  for (int v = border_px; v < test::pair_camera.height - border_px; ++v) {
    for (int u = left_px; u < test::pair_camera.width - border_px; ++u) use(u, v);
  }
}

double rms_error_px(const Image<float>& disparity, const Image<float>& truth) {
  double squares = 0.0;
  int count = 0;
  for_each_judged([&](int u, int v) {
    squares += std::pow(static_cast<double>(disparity(u, v) - truth(u, v)), 2);
    ++count;
  });
  return std::sqrt(squares / count);
}

double error_of(const test::Plane& plane, std::size_t captures, float start_error_px, std::uint64_t seed) {
  const Image<float> truth = test::true_disparity(plane);
  const std::vector<StereoView> views = test::dithered_pairs(plane, captures, speckle, seed);
  return rms_error_px(space_time_disparity(test::off_by(truth, start_error_px), test::pair_stereo, views),
                      truth);
}

TEST(SpaceTime, FindsAWallToASmallShareOfAPixelFromAnywhereInRange) {
  for (const float start_error_px : {-2.6F, 0.0F, 1.3F})
    EXPECT_LT(error_of({}, 8, start_error_px, 1), 0.06) << start_error_px;
}

TEST(SpaceTime, MorePairsAreBetter) {
  const double one = error_of({}, 1, 0.4F, 2);
  const double eight = error_of({}, 8, 0.4F, 2);
  EXPECT_LT(eight, 0.6 * one);
}

TEST(SpaceTime, WindowsFollowASlopingStart) {
  EXPECT_LT(error_of({.depth_m = 0.8, .slope = 0.8}, 8, 0.5F, 3), 0.08);
}

TEST(SpaceTime, AStepIsSharpToTwoPixels) {
  const test::Plane step{.depth_m = 0.8, .slope = 0.0, .step_m = 0.04, .step_x_m = 0.02};
  const Image<float> truth = test::true_disparity(step);
  const Image<float> wall = test::true_disparity({});
  const std::vector<StereoView> views = test::dithered_pairs(step, 8, speckle, 4);
  const Image<float> found = space_time_disparity(test::off_by(wall, 0.0F), test::pair_stereo, views);
  int wrong = 0;
  int count = 0;
  for_each_judged([&](int u, int v) {
    const float before = truth(u - 4, v);
    const float after = truth(u + 4, v);
    if (std::abs(before - after) > 0.3F) return;  // at the step, and where the right imager does not see
    ++count;
    if (std::abs(found(u, v) - truth(u, v)) > 0.4F) ++wrong;
  });
  EXPECT_LT(wrong, count / 50);
}

TEST(SpaceTime, WhatNoPairSeesIsUnknown) {
  const Image<float> truth = test::true_disparity({});
  const std::vector<StereoView> views = test::dithered_pairs({}, 2, speckle, 5);
  const Image<float> found = space_time_disparity(test::off_by(truth, 0.0F), test::pair_stereo, views);
  for (int v = 0; v < found.height(); ++v) EXPECT_EQ(found(3, v), 0.0F) << v;
}

TEST(SpaceTime, CostsOfAllPairsAreTheSumOfThoseOfEach) {
  const Image<float> truth = test::true_disparity({});
  const std::vector<StereoView> views = test::dithered_pairs({}, 3, speckle, 6);
  const ReferenceSurface start = test::off_by(truth, 0.2F);
  const SweptCosts all = sweep(start, test::pair_stereo, views);
  std::vector<SweptCosts> single;
  for (const StereoView& view : views) single.push_back(sweep(start, test::pair_stereo, {&view, 1}));
  for_each_judged([&](int u, int v) {
    for (std::size_t label = 0; label < all.at(u, v).size(); ++label) {
      float sum = 0.0F;
      for (const SweptCosts& costs : single) sum += costs.at(u, v)[label];
      EXPECT_NEAR(all.at(u, v)[label], sum, 1e-3F * sum + 1e-4F);
    }
  });
}

TEST(SpaceTime, OneSidesBrightnessDoesNotCount) {
  const Image<float> truth = test::true_disparity({});
  std::vector<StereoView> views = test::dithered_pairs({}, 2, speckle, 7);
  const ReferenceSurface start = test::off_by(truth, 0.2F);
  const SweptCosts before = sweep(start, test::pair_stereo, views);
  for (StereoView& view : views) {
    for (float& value : view.right.pixels()) value += 0.4F;
  }
  const SweptCosts after = sweep(start, test::pair_stereo, views);
  for_each_judged([&](int u, int v) {
    for (std::size_t label = 0; label < before.at(u, v).size(); ++label)
      EXPECT_NEAR(after.at(u, v)[label], before.at(u, v)[label], 2e-3F);
  });
}

TEST(SpaceTime, EachPairIsMovedToWhereTheSurfaceIs) {
  const Image<float> truth = test::true_disparity({});
  std::vector<StereoView> views = test::dithered_pairs({}, 3, speckle, 8);
  views[1].excess_px = 0.3;
  align_disparities(test::off_by(truth, 0.1F), test::pair_stereo, views);
  for (const StereoView& view : views) EXPECT_NEAR(view.excess_px, -0.1, 0.05);
}

TEST(SpaceTime, TheMinimumOfAParabolaIsExact) {
  std::vector<float> costs;
  for (int label = 0; label < 9; ++label)
    costs.push_back(0.7F + 0.5F * std::pow(static_cast<float>(label) - 3.3F, 2.0F));
  const Minimum minimum = minimum_of(costs);
  EXPECT_NEAR(minimum.label, 3.3F, 1e-5F);
  EXPECT_NEAR(minimum.cost, 0.7F, 1e-5F);
  std::ranges::reverse(costs);
  EXPECT_NEAR(minimum_of(costs).label, 4.7F, 1e-5F);
  EXPECT_EQ(minimum_of(std::vector{1.0F, 2.0F, 3.0F}).label, 0.0F) << "at the end there is nothing to fit";
}

}  // namespace
}  // namespace rva
