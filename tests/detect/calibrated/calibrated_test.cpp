#include "detect/calibrated/calibrated.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "detect/findings/findings.hpp"
#include "detect/regions/regions.hpp"
#include "geometry/stereo_scale.hpp"
#include "tests/detect/calibrated/noisy_captures.hpp"

namespace rva {
namespace {

using test::NoisyCapture;

CalibratedComparison compare(const DepthStatistics& before, const DepthStatistics& after,
                             const CalibratedOptions& options = {}) {
  return compare_calibrated(before, after, test::stereo, options);
}

Intrinsics camera() {
  Intrinsics camera;
  camera.width = 424;
  camera.height = 240;
  camera.fx = camera.fy = 212.5;
  camera.cx = 211.5;
  camera.cy = 119.5;
  return camera;
}

std::vector<Finding> find(const DepthStatistics& before, const DepthStatistics& after,
                          const CalibratedOptions& options = {}) {
  const Comparison comparison = compare(before, after, options).comparison;
  return find_findings(comparison, {}, camera());
}

/// A step of so much disparity over a square of so many pixels in the middle.
NoisyCapture with_thing(NoisyCapture capture, double lift_px, int side_px) {
  capture.disparity_px = [=](int u, int v) {
    const bool inside = std::abs(u - 212) <= side_px / 2 && std::abs(v - 120) <= side_px / 2;
    return inside ? 25.0 + lift_px : 25.0;
  };
  return capture;
}

TEST(Calibrated, FindsWhatWasAdded) {
  const NoisyCapture empty;
  const std::vector<Finding> findings = find(empty.take(1), with_thing(empty, 0.3, 9).take(2));
  ASSERT_EQ(findings.size(), 1);
  EXPECT_EQ(findings[0].kind, ChangeKind::added);
  EXPECT_NEAR(findings[0].centroid.x(), 212.0, 1.5);
  EXPECT_NEAR(findings[0].centroid.y(), 120.0, 1.5);
  // 21.25 / 25 - 21.25 / 25.3 m.
  EXPECT_NEAR(*findings[0].height_mm, 10.1, 1.5);
  EXPECT_LT(*findings[0].p_value, 1e-4);
  EXPECT_GT(*findings[0].score, 4.0);
}

TEST(Calibrated, LooksBothWays) {
  const NoisyCapture empty;
  const DepthStatistics before = empty.take(1);
  const DepthStatistics after = with_thing(empty, 0.3, 9).take(2);
  const std::vector<Finding> findings = find(after, before);
  ASSERT_EQ(findings.size(), 1);
  EXPECT_EQ(findings[0].kind, ChangeKind::removed);
  EXPECT_LT(*findings[0].height_mm, 0.0);
  EXPECT_EQ(findings[0].box, find(before, after)[0].box) << "the same region, seen the other way round";
}

TEST(Calibrated, ManyFaintPixelsAreAChangeToo) {
  NoisyCapture empty;
  const NoisyCapture ragged = with_thing(empty, 0.03, 81);  // a deviation and a half of one pixel's mean
  ASSERT_EQ(find(empty.take(1), ragged.take(2)).size(), 1);
}

TEST(Calibrated, DriftIsNoChange) {
  const NoisyCapture empty;
  NoisyCapture warm = empty;
  warm.disparity_px = [](int u, int v) { return 25.2 + 0.0004 * u - 0.0003 * v; };
  EXPECT_TRUE(find(empty.take(1), warm.take(2)).empty());
}

TEST(Calibrated, HeightsAreWithoutDrift) {
  const NoisyCapture empty;
  NoisyCapture warm = with_thing(empty, 0.3, 9);
  warm.disparity_px = [still = warm.disparity_px](int u, int v) { return still(u, v) - 0.5; };
  const std::vector<Finding> findings = find(empty.take(1), warm.take(2));
  ASSERT_EQ(findings.size(), 1);
  EXPECT_EQ(findings[0].kind, ChangeKind::added) << "though it is farther than before by what drifted";
  EXPECT_NEAR(*findings[0].height_mm, 10.5, 1.5);
}

// White noise has a lighter tail than a camera's, for which the detector is made: far fewer findings than
// allowed, but some where many are allowed.
TEST(Calibrated, FalseFindingsOfWhiteNoiseStayBelowWhatIsAllowed) {
  NoisyCapture empty;
  empty.frames = 4;
  std::size_t few = 0;
  std::size_t many = 0;
  constexpr int pairs = 40;
  for (std::uint64_t seed = 0; seed < pairs; ++seed) {
    const DepthStatistics before = empty.take(1000 + 2 * seed);
    const DepthStatistics after = empty.take(1001 + 2 * seed);
    few += find(before, after, {.false_findings = 1.0}).size();
    many += find(before, after, {.false_findings = 100.0}).size();
  }
  EXPECT_LE(few, pairs);
  EXPECT_GE(many, pairs);
  EXPECT_LE(many, 100 * pairs);
}

NoisyCapture with_hole(NoisyCapture capture, int side_px) {
  capture.disparity_px = [=](int u, int v) {
    return std::abs(u - 212) <= side_px / 2 && std::abs(v - 120) <= side_px / 2 ? 0.0 : 25.0;
  };
  return capture;
}

// Glass and bare metal leave no depth.
TEST(Calibrated, DepthThatWentMissingIsAChangeWithoutHeight) {
  const NoisyCapture empty;
  const std::vector<Finding> findings = find(empty.take(1), with_hole(empty, 9).take(2));
  ASSERT_EQ(findings.size(), 1);
  EXPECT_EQ(findings[0].kind, ChangeKind::added);
  EXPECT_FALSE(findings[0].height_mm);
  EXPECT_EQ(findings[0].pixels.size(), 81);
  ASSERT_TRUE(findings[0].position_m);
  EXPECT_NEAR(findings[0].position_m->z(), 0.85, 0.001) << "where the surface was before";
  EXPECT_GT(*findings[0].score, 1.3);
}

TEST(Calibrated, DepthThatCameBackIsAChangeToo) {
  const NoisyCapture empty;
  const std::vector<Finding> findings = find(with_hole(empty, 9).take(1), empty.take(2));
  ASSERT_EQ(findings.size(), 1);
  EXPECT_EQ(findings[0].kind, ChangeKind::removed);
  EXPECT_FALSE(findings[0].height_mm);
}

TEST(Calibrated, HolesThatStayAreNoChange) {
  const NoisyCapture holed = with_hole({}, 25);
  EXPECT_TRUE(find(holed.take(1), holed.take(2)).empty());
}

TEST(Calibrated, FindsNothingWhereNeitherSaw) {
  NoisyCapture blind;
  blind.disparity_px = [](int u, int /*v*/) { return u < 212 ? 25.0 : 0.0; };
  const CalibratedComparison result = compare(blind.take(1), blind.take(2));
  EXPECT_EQ(result.comparison.changed, Mask(424, 240));
  EXPECT_DOUBLE_EQ(result.comparison.coverage.compared, 0.5);
  EXPECT_DOUBLE_EQ(result.comparison.coverage.invalid, 0.5);
  EXPECT_TRUE(std::isnan(result.level_of_detection_mm(300, 120)));
  EXPECT_FALSE(std::isnan(result.level_of_detection_mm(100, 120)));
  EXPECT_NEAR(result.levels.judged, 206.0 * 228.0 / (424.0 * 240.0), 0.001)
      << "half of it, without its margin";
}

TEST(Calibrated, WithoutFramesThereIsNothingToFind) {
  const CalibratedComparison nothing = compare(NoisyCapture().take(1), DepthStatistics(424, 240));
  EXPECT_EQ(nothing.comparison.changed, Mask(424, 240));
  EXPECT_EQ(nothing.levels.judged, 0.0);
  EXPECT_TRUE(nothing.levels.by_distance.empty());
}

TEST(Calibrated, JudgesNoPixelThatJumps) {
  const NoisyCapture empty;
  NoisyCapture jumping = empty;
  jumping.disparity_px = [count = 0](int u, int v) mutable {
    const bool there = u > 100 && u < 130 && v > 100 && v < 130;
    return there && ++count % 2 == 0 ? 60.0 : 25.0;
  };
  const CalibratedComparison result = compare(empty.take(1), jumping.take(2));
  EXPECT_TRUE(std::isnan(result.level_of_detection_mm(115, 115)));
  EXPECT_EQ(result.comparison.changed, Mask(424, 240));
}

// The level is defined for nine inspections of ten: of 40, 36 are expected, and 29 or fewer happen once in a
// thousand times.
TEST(Calibrated, FindsNineOfTenAtItsLevel) {
  const NoisyCapture empty;
  const CalibratedComparison clean = compare(empty.take(1), empty.take(2));
  const double level_m = clean.level_of_detection_mm(212, 120) / 1000.0;
  const double depth_m = test::stereo.depth_m(25.0);
  const auto found_at = [&](double height_m) {
    const double lift_px = test::stereo.disparity_px(depth_m - height_m) - 25.0;
    int found = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const NoisyCapture changed = with_thing(empty, lift_px, 9);
      found += find(empty.take(2000 + 2 * seed), changed.take(2001 + 2 * seed)).empty() ? 0 : 1;
    }
    return found;
  };
  EXPECT_GE(found_at(level_m), 30);
  EXPECT_LE(found_at(0.5 * level_m), 10) << "and not much less";
}

TEST(Calibrated, BaselineOnlyScalesDisparity) {
  const NoisyCapture empty;
  const DepthStatistics before = empty.take(1);
  const DepthStatistics after = with_thing(empty, 0.3, 9).take(2);
  const CalibratedComparison one = compare(before, after);
  StereoScale twice = test::stereo;
  twice.focal_baseline_m_px *= 2.0;
  const CalibratedComparison other = compare_calibrated(before, after, twice, {});
  EXPECT_EQ(one.comparison.changed, other.comparison.changed);
  EXPECT_NEAR(one.level_of_detection_mm(50, 50), other.level_of_detection_mm(50, 50), 1e-4);
}

TEST(Calibrated, WorksOnSingleFrames) {
  NoisyCapture empty;
  empty.frames = 1;
  const std::vector<Finding> findings = find(empty.take(1), with_thing(empty, 2.0, 25).take(2));
  ASSERT_EQ(findings.size(), 1);
  EXPECT_FALSE(compare(empty.take(1), empty.take(2)).levels.effective_frames);
}

}  // namespace
}  // namespace rva
