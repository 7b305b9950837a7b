#include "evaluate/judgement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/stereo_scale.hpp"

namespace rva {
namespace {

using testing::ElementsAre;

constexpr int width = 100;
constexpr int height = 80;

std::vector<std::uint32_t> square(int left, int top, int side) {
  std::vector<std::uint32_t> pixels;
  for (int v = top; v < top + side; ++v) {
    for (int u = left; u < left + side; ++u) pixels.push_back(static_cast<std::uint32_t>(v * width + u));
  }
  return pixels;
}

Finding finding(int left, int top, int side) {
  Finding finding;
  finding.pixels = square(left, top, side);
  return finding;
}

std::vector<Target> one_target() { return {{"key", 25, 25.0, 0.5, square(40, 40, 5)}}; }

TEST(Judgement, WithinHalfAWindowIsFound) {
  const std::vector<Finding> at_edge{finding(48, 40, 3)};
  EXPECT_THAT(judge(at_edge, one_target(), width, height).found, ElementsAre(true));
  const std::vector<Finding> beyond{finding(49, 40, 3)};
  const Judgement shadow = judge(beyond, one_target(), width, height);
  EXPECT_THAT(shadow.found, ElementsAre(false));
  EXPECT_EQ(shadow.false_findings, 0) << "near enough to be its shadow";
}

TEST(Judgement, FarFromAllDebrisIsFalse) {
  const Judgement judgement = judge({finding(70, 40, 3), finding(42, 42, 2)}, one_target(), width, height);
  EXPECT_EQ(judgement.false_findings, 1);
  EXPECT_THAT(judgement.found, ElementsAre(true));
}

TEST(Judgement, AFindingThatMarksEverythingPointsAtNothing) {
  const Judgement judgement = judge({finding(0, 0, 80)}, one_target(), width, height);
  EXPECT_EQ(judgement.false_findings, 1);
  EXPECT_THAT(judgement.found, ElementsAre(false));
}

TEST(Judgement, PlannedWorkIsNeitherDebrisNorFalse) {
  const std::vector<Finding> findings{finding(70, 40, 3), finding(42, 42, 2), finding(5, 5, 2)};
  const Judgement judgement = judge(findings, one_target(), width, height, {square(72, 38, 4), {}});
  EXPECT_EQ(judgement.work_findings, 1);
  EXPECT_EQ(judgement.false_findings, 1);
  EXPECT_THAT(judgement.found, ElementsAre(true));
}

TEST(Judgement, TracesAreCountedApartButForWorkOnThem) {
  const std::vector<Finding> findings{finding(70, 40, 3), finding(5, 5, 2)};
  const Judgement traces = judge(findings, one_target(), width, height, {{}, square(72, 38, 4)});
  EXPECT_EQ(traces.trace_findings, 1);
  EXPECT_EQ(traces.false_findings, 1);
  const Judgement both = judge(findings, one_target(), width, height, {square(72, 38, 4), square(72, 38, 4)});
  EXPECT_EQ(both.work_findings, 1);
  EXPECT_EQ(both.trace_findings, 0);
}

TEST(Judgement, DebrisBesideWorkIsDebris) {
  const Judgement judgement =
      judge({finding(40, 40, 3)}, one_target(), width, height, {square(38, 38, 10), {}});
  EXPECT_EQ(judgement.work_findings, 0);
  EXPECT_THAT(judgement.found, ElementsAre(true));
}

TEST(Judgement, WithoutTargetsAllIsFalse) {
  EXPECT_EQ(judge({finding(70, 40, 3)}, {}, width, height).false_findings, 1);
}

DepthStatistics flat(const std::vector<std::uint32_t>& others, std::uint16_t other) {
  DepthImage depth(width, height, 10000);
  for (const std::uint32_t i : others) depth[i] = other;
  DepthStatistics statistics(width, height);
  statistics.add(depth);
  return statistics;
}

// 212500 / 10000 is 21.25 px; at 9950, 0.107 px more; at 9960, 0.085.
TEST(Shown, IsWhatChangesDisparityOrTakesItAway) {
  constexpr StereoScale stereo{.focal_baseline_m_px = 21.25, .unit_m = 0.0001};
  const DepthStatistics without = flat({}, 0);
  std::vector<Target> targets = one_target();
  count_shown(without, flat(square(38, 38, 5), 9950), stereo, targets);
  EXPECT_EQ(targets[0].shown_px, 25);
  EXPECT_TRUE(targets[0].is_shown());
  count_shown(without, flat(square(38, 38, 5), 9960), stereo, targets);
  EXPECT_EQ(targets[0].shown_px, 0);
  EXPECT_FALSE(targets[0].is_shown());
  count_shown(without, flat(square(47, 47, 5), 0), stereo, targets);
  EXPECT_EQ(targets[0].shown_px, 4) << "2 x 2 of the lost pixels are within 4 px of the target";
  count_shown(flat(square(38, 38, 5), 0), without, stereo, targets);
  EXPECT_EQ(targets[0].shown_px, 25) << "depth that debris brings";
}

TEST(Target, HalfHiddenIsVisible) {
  EXPECT_TRUE((Target{"key", 5, 10.0, 0.5, {}}.is_visible()));
  EXPECT_FALSE((Target{"key", 4, 10.0, 0.5, {}}.is_visible()));
  EXPECT_FALSE((Target{"key", 0, 0.0, 0.5, {}}.is_visible()));
}

}  // namespace
}  // namespace rva
