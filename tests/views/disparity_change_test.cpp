#include "views/disparity_change.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/depth/stacks.hpp"

namespace rva {
namespace {

constexpr int width = 40;
constexpr int height = 30;
constexpr StereoScale stereo{.focal_baseline_m_px = 20.0, .unit_m = 0.001};
constexpr std::size_t centre = 15 * width + 20;

DepthStatistics statistics_of(const std::vector<DepthImage>& frames) {
  DepthStatistics statistics(frames.at(0).width(), frames.at(0).height());
  statistics.add(frames);
  return statistics;
}

std::vector<DepthImage> flat(std::uint16_t depth, int frames) {
  return {static_cast<std::size_t>(frames), DepthImage(width, height, depth)};
}

/// Depths of one pixel in frames that are flat otherwise.
std::vector<DepthImage> at_centre(std::initializer_list<std::uint16_t> depths) {
  std::vector<DepthImage> frames = flat(1000, static_cast<int>(depths.size()));
  std::size_t i = 0;
  for (const std::uint16_t depth : depths) frames[i++][centre] = depth;
  return frames;
}

struct Disparity {
  double mean_px = 0.0;  // of the mean depth
  double variance_px2 = 0.0;
};

// Each depth is converted, and their scatter is taken in pixels, without a derivative.
Disparity disparity_of(const std::vector<DepthImage>& frames, std::size_t pixel) {
  double sum = 0.0;
  double count = 0.0;
  for (const DepthImage& frame : frames) {
    sum += frame[pixel];
    count += frame[pixel] != no_depth ? 1.0 : 0.0;
  }
  Disparity disparity{stereo.disparity_px(stereo.unit_m * sum / count), 0.0};
  for (const DepthImage& frame : frames) {
    if (frame[pixel] == no_depth) continue;
    const double off_px = stereo.disparity_px(stereo.unit_m * frame[pixel]) - disparity.mean_px;
    disparity.variance_px2 += off_px * off_px / count;
  }
  return disparity;
}

TEST(DisparityChange, IsThatOfTheDepthsConvertedOneByOne) {
  std::mt19937 random(1);
  const auto before = test::random_stack({width, height, 9}, 1500, 12, 0.2, random);
  const auto after = test::random_stack({width, height, 6}, 1470, 8, 0.2, random);
  const DisparityChange change = disparity_change(statistics_of(before), statistics_of(after), stereo);
  EXPECT_EQ(change.frames, 6U);
  int judged = 0;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (change.judged[i] == 0) continue;
    ++judged;
    const Disparity first = disparity_of(before, i);
    const Disparity second = disparity_of(after, i);
    EXPECT_NEAR(change.before_px[i], first.mean_px, 1e-5);
    EXPECT_NEAR(change.change_px(i), second.mean_px - first.mean_px, 2e-5);
    EXPECT_NEAR(change.deviation_px[i], std::sqrt(first.variance_px2 + second.variance_px2), 2e-3);
  }
  EXPECT_GT(judged, 400);
}

TEST(DisparityChange, OfSwappedSidesIsTheOpposite) {
  std::mt19937 random(2);
  const DepthStatistics a = statistics_of(test::random_stack({width, height, 5}, 900, 9, 0.3, random));
  const DepthStatistics b = statistics_of(test::random_stack({width, height, 8}, 950, 9, 0.1, random));
  const DisparityChange there = disparity_change(a, b, stereo);
  const DisparityChange back = disparity_change(b, a, stereo);
  EXPECT_EQ(there.judged, back.judged);
  for (std::size_t i = 0; i < there.judged.size(); ++i) {
    EXPECT_EQ(there.change_px(i), -back.change_px(i));
    EXPECT_EQ(there.lost[i], -back.lost[i]);
    EXPECT_NEAR(there.deviation_px[i], back.deviation_px[i], 1e-6);
  }
}

TEST(DisparityChange, IsPositiveWhereSomethingCameNearer) {
  const DisparityChange change =
      disparity_change(statistics_of(flat(1000, 4)), statistics_of(flat(800, 4)), stereo);
  EXPECT_NEAR(change.change_px(centre), 5.0, 1e-5);
}

TEST(DisparityChange, DoesNotDependOnTheDepthUnit) {
  StereoScale fine = stereo;
  fine.unit_m = stereo.unit_m / 10.0;
  const DisparityChange coarse =
      disparity_change(statistics_of(at_centre({1000, 1010})), statistics_of(at_centre({990, 980})), stereo);
  std::vector<DepthImage> before = at_centre({1000, 1010});
  std::vector<DepthImage> after = at_centre({990, 980});
  for (auto* const frames : {&before, &after})
    for (DepthImage& frame : *frames)
      for (std::uint16_t& depth : frame.pixels()) depth = static_cast<std::uint16_t>(10 * depth);
  const DisparityChange same = disparity_change(statistics_of(before), statistics_of(after), fine);
  EXPECT_NEAR(same.change_px(centre), coarse.change_px(centre), 1e-5);
  EXPECT_NEAR(same.deviation_px[centre], coarse.deviation_px[centre], 1e-6);
}

TEST(DisparityChange, IsNotJudgedWhereASideDidNotSeeThePixel) {
  const DepthStatistics always = statistics_of(flat(1000, 4));
  const DepthStatistics half = statistics_of(at_centre({1000, 0, 0, 1000}));
  const DepthStatistics rarely = statistics_of(at_centre({1000, 0, 0, 0}));
  EXPECT_NE(disparity_change(always, half, stereo).judged[centre], 0);
  EXPECT_EQ(disparity_change(always, half, stereo).lost[centre], 0.5F);
  const DisparityChange lost = disparity_change(always, rarely, stereo);
  EXPECT_EQ(lost.judged[centre], 0);
  EXPECT_EQ(lost.lost[centre], 0.75F);
  EXPECT_EQ(lost.after_px[centre], 0.0F);
  EXPECT_EQ(lost.deviation_px[centre], 0.0F);
  EXPECT_EQ(disparity_change(rarely, always, stereo).lost[centre], -0.75F) << "it came back";
}

TEST(DisparityChange, IsNotJudgedInTheMargin) {
  std::vector<DepthImage> nothing = flat(0, 2);
  const DisparityChange seen =
      disparity_change(statistics_of(flat(1000, 2)), statistics_of(flat(1000, 2)), stereo);
  const DisparityChange lost = disparity_change(statistics_of(flat(1000, 2)), statistics_of(nothing), stereo);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const bool inside = u >= margin_px && u < width - margin_px && v >= margin_px && v < height - margin_px;
      EXPECT_EQ(seen.judged(u, v) != 0, inside) << u << ", " << v;
      EXPECT_EQ(lost.lost(u, v), inside ? 1.0F : 0.0F) << u << ", " << v;
    }
  }
}

// The mean of two surfaces is the depth of neither.
TEST(DisparityChange, IsNotJudgedWhereMatchesAlternateBetweenSurfaces) {
  std::mt19937 random(3);
  std::vector<DepthImage> before = test::random_stack({width, height, 8}, 1000, 2, 0.0, random);
  const std::vector<DepthImage> after = test::random_stack({width, height, 8}, 1000, 2, 0.0, random);
  EXPECT_NE(disparity_change(statistics_of(before), statistics_of(after), stereo).judged[centre], 0);
  for (std::size_t k = 0; k < before.size(); k += 2) before[k][centre] = 1400;
  const DisparityChange change = disparity_change(statistics_of(before), statistics_of(after), stereo);
  EXPECT_EQ(change.judged[centre], 0);
  EXPECT_EQ(change.deviation_px[centre], 0.0F);
  EXPECT_NE(change.judged[centre + 1], 0);
}

TEST(DisparityChange, OfSingleFramesIsJudgedWithoutADeviation) {
  const DisparityChange change =
      disparity_change(statistics_of(flat(1000, 1)), statistics_of(flat(900, 1)), stereo);
  EXPECT_NE(change.judged[centre], 0);
  EXPECT_EQ(change.deviation_px[centre], 0.0F);
}

TEST(DisparityChange, OfNoFramesIsNothing) {
  const DepthStatistics none(width, height);
  const DisparityChange change = disparity_change(statistics_of(flat(1000, 3)), none, stereo);
  EXPECT_EQ(change.frames, 0U);
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    EXPECT_EQ(change.judged[i], 0);
    EXPECT_EQ(change.lost[i], 0.0F);
  }
}

/// The left `columns` columns.
Mask left(int columns) {
  Mask mask(width, height);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < columns; ++u) mask(u, v) = mask_set;
  return mask;
}

TEST(DisparityChange, LeftOutPixelsTeachNoNoiseUnlessTheyAreMostOfTheImage) {
  const DisparityChange whole =
      disparity_change(statistics_of(at_centre({1000, 1010})), statistics_of(at_centre({0, 0})), stereo);
  ASSERT_EQ(whole.lost[centre], 1.0F);
  for (const auto& [columns, still_judged] : {std::pair{width / 2, false}, {width / 2 + 1, true}}) {
    DisparityChange change = whole;
    leave_out(change, left(columns));
    EXPECT_EQ(change.left_out, left(columns));
    EXPECT_EQ(change.judged(10, 15) != 0, still_judged) << columns;
    EXPECT_NE(change.judged(30, 15), 0);
    EXPECT_EQ(change.lost[centre], 1.0F);
  }
  DisparityChange change = whole;
  leave_out(change, {});
  EXPECT_EQ(change.judged, whole.judged);
}

TEST(DisparityChange, LossesAreForgottenAndNothingElse) {
  const DisparityChange whole =
      disparity_change(statistics_of(flat(1000, 2)), statistics_of(at_centre({0, 1000})), stereo);
  ASSERT_EQ(whole.lost[centre], 0.5F);
  DisparityChange change = whole;
  forget_losses(change);
  EXPECT_EQ(change.lost, Image<float>(width, height));
  EXPECT_EQ(change.judged, whole.judged);
  EXPECT_EQ(change.after_px, whole.after_px);
}

}  // namespace
}  // namespace rva
