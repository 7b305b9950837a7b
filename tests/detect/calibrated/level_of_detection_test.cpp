#include "detect/calibrated/level_of_detection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/random.hpp"

namespace rva {
namespace {

constexpr int width = 200;
constexpr int height = 160;
constexpr StereoScale stereo{.focal_baseline_m_px = 20.0, .unit_m = 0.0001};
constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

Scale scale_with(int window_px, double threshold, double spread = 1.0) {
  const FalseAlarmTail tail(1.0, 1.0, 10.0);
  return {PooledEvidence{window_px, Image<float>(width, height), Mask(width, height, mask_set), spread},
          {tail, tail},
          {threshold, threshold}};
}

/// Levels of a flat wall.
Image<float> levels_of(const Scale& scale, float deviation_px = 0.1F, float depth_m = 1.0F) {
  return level_of_detection_mm(Mask(width, height), Image<float>(width, height, deviation_px),
                               Image<float>(width, height, depth_m), scale, stereo);
}

constexpr int object_px = 9;

struct Corner {
  int u;
  int v;
};

// The upper left corners of objects that do not touch each other.
std::vector<Corner> corners() {
  constexpr int apart_px = 20;
  std::vector<Corner> all;
  for (int v = apart_px; v < height - apart_px; v += apart_px)
    for (int u = apart_px; u < width - apart_px; u += apart_px) all.push_back({u, v});
  return all;
}

// Noise of deviation 1, and objects that raise it by so many deviations.
Image<float> noise_with_objects(Random& random, float deviations) {
  Image<float> evidence(width, height);
  for (float& pixel : evidence.pixels()) pixel = static_cast<float>(random.normal());
  for (const auto& [u, v] : corners())
    for (int i = 0; i < object_px * object_px; ++i)
      evidence(u + i % object_px, v + i / object_px) += deviations;
  return evidence;
}

// Objects as wide as the window and as high as the level are put into noise.
TEST(LevelOfDetection, IsTheHeightThatNineOfTenInspectionsFind) {
  constexpr double threshold = 6.0;
  constexpr float deviation_px = 0.1F;
  constexpr double depth_m = 0.9;
  const float level_mm =
      levels_of(scale_with(object_px, threshold), deviation_px, static_cast<float>(depth_m))(100, 80);
  // Small beside the depth, as the level is for heights along z.
  const double change_px = stereo.disparity_px(depth_m - level_mm / 1000.0) - stereo.disparity_px(depth_m);
  Random random(1);
  std::size_t objects = 0;
  std::size_t found = 0;
  for (int image = 0; image < 10; ++image) {
    const Image<float> evidence = noise_with_objects(random, static_cast<float>(change_px) / deviation_px);
    const PooledEvidence pooled = pool(evidence, Mask(width, height, mask_set), object_px, 1.0);
    for (const auto& [u, v] : corners()) {
      ++objects;
      const float deviations = pooled.deviations(u + object_px / 2, v + object_px / 2);
      found += static_cast<double>(deviations) > threshold ? 1U : 0U;
    }
  }
  EXPECT_NEAR(static_cast<double>(found) / static_cast<double>(objects), 0.9, 0.05) << objects;
}

TEST(LevelOfDetection, FollowsNoiseDepthSpreadAndWindow) {
  const float level_mm = levels_of(scale_with(10, 8.0))(100, 80);
  EXPECT_NEAR(level_mm, 1000.0 * (8.0 + 1.2816) / 10.0 * 0.1 / 20.0, 1e-4);
  EXPECT_NEAR(levels_of(scale_with(10, 8.0), 0.3F)(100, 80), 3.0F * level_mm, 1e-3);
  EXPECT_NEAR(levels_of(scale_with(10, 8.0), 0.1F, 2.0F)(100, 80), 4.0F * level_mm, 1e-3);
  EXPECT_NEAR(levels_of(scale_with(10, 8.0, 2.0))(100, 80), 2.0F * level_mm, 1e-3);
  EXPECT_NEAR(levels_of(scale_with(20, 8.0))(100, 80), level_mm / 2.0F, 1e-3);
}

TEST(LevelOfDetection, IsThatOfThePixelsClass) {
  Scale scale = scale_with(10, 8.0);
  scale.thresholds.unreliable = 2.0 * (8.0 + 1.2816) - 1.2816;
  Mask unreliable(width, height);
  unreliable(100, 80) = mask_set;
  const Image<float> levels = level_of_detection_mm(unreliable, Image<float>(width, height, 0.1F),
                                                    Image<float>(width, height, 1.0F), scale, stereo);
  EXPECT_NEAR(levels(100, 80), 2.0F * levels(101, 80), 1e-3);
}

TEST(LevelOfDetection, IsUnknownWhereNothingIsPooledAndWhereNoHeightSuffices) {
  Scale scale = scale_with(5, 8.0);
  scale.evidence.pooled(10, 10) = 0;
  EXPECT_TRUE(std::isnan(levels_of(scale)(10, 10)));
  EXPECT_FALSE(std::isnan(levels_of(scale)(11, 10)));
  // Pixels of 20 deviations at most, over a window of 5: 100 deviations.
  EXPECT_FALSE(std::isnan(levels_of(scale_with(5, 98.0))(10, 10)));
  EXPECT_TRUE(std::isnan(levels_of(scale_with(5, 99.0))(10, 10)));
}

TEST(LevelOfDetection, RisesBesideNoisyPixelsAndIgnoresThoseNotJudged) {
  Image<float> deviation_px(width, height, 0.1F);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < 50; ++u) deviation_px(u, v) = 0.5F;
    for (int u = 140; u < 149; ++u) deviation_px(u, v) = 0.3F;
    for (int u = 150; u < width; ++u) deviation_px(u, v) = 0.0F;
  }
  const Image<float> levels = level_of_detection_mm(
      Mask(width, height), deviation_px, Image<float>(width, height, 1.0F), scale_with(9, 8.0), stereo);
  const float usual_mm = levels(100, 80);
  EXPECT_NEAR(levels(20, 80), 5.0F * usual_mm, 1e-3);
  EXPECT_NEAR(levels(50, 80), (4 * 0.5F + 5 * 0.1F) / 9 / 0.1F * usual_mm, 1e-2) << "the mean of the window";
  EXPECT_NEAR(levels(149, 80), (4 * 0.3F + 0.1F) / 5 / 0.1F * usual_mm, 1e-2) << "of the judged ones only";
}

TEST(LevelOfDetection, IsStatedForTheFinestScaleThatAChangeCanReach) {
  const std::array scales{scale_with(5, 200.0), scale_with(9, 170.0), scale_with(15, 170.0),
                          scale_with(25, 8.0)};
  EXPECT_EQ(finest_reachable(scales).evidence.window_px, 9);
  EXPECT_EQ(finest_reachable(std::span(scales).first(1)).evidence.window_px, 5) << "if none is, the last";
}

TEST(LevelsByDistance, AreQuantilesOfClassesOfTwentyCentimetres) {
  constexpr int wide = 300;
  Image<float> level_mm(wide, 1, unknown);
  Image<float> depth_m(wide, 1);
  // Every third pixel is sampled: near ones have levels 0 to 49, far ones 100.
  for (int i = 0; i < 50; ++i) {
    level_mm(3 * i, 0) = static_cast<float>(49 - i);
    depth_m(3 * i, 0) = 0.55F;
    level_mm(150 + 3 * i, 0) = 100.0F;
    depth_m(150 + 3 * i, 0) = 1.3F;
  }
  EXPECT_NEAR(judged_share(level_mm), 1.0 / 3.0, 1e-9);
  const std::vector<DetectionLevels> levels = levels_by_distance(level_mm, depth_m);
  ASSERT_EQ(levels.size(), 2U) << "classes without pixels are left out";
  EXPECT_NEAR(levels[0].from_m, 0.4, 1e-9);
  EXPECT_NEAR(levels[0].to_m, 0.6, 1e-9);
  EXPECT_EQ(levels[0].pixels, 50U);
  EXPECT_EQ(levels[0].median_mm, 24.0);
  EXPECT_EQ(levels[0].p90_mm, 44.0);
  EXPECT_NEAR(levels[1].from_m, 1.2, 1e-9);
  EXPECT_EQ(levels[1].p90_mm, 100.0);
  EXPECT_TRUE(levels_by_distance(Image<float>(9, 9, unknown), Image<float>(9, 9)).empty());
}

TEST(LevelsByDistance, AreWrittenWithNamesAndUnits) {
  DetectionLevelSummary summary{0.5, 9, -0.25, 0.125, std::nullopt, {{0.4, 0.6, 50, 24.0, 44.0}}};
  EXPECT_EQ(json_of(summary), nlohmann::ordered_json::parse(R"({
    "format": "rva-level-of-detection", "version": 1, "judged": 0.5, "window_px": 9, "drift_px": -0.25,
    "fixed_px": 0.125,
    "by_distance": [{"from_m": 0.4, "to_m": 0.6, "pixels": 50, "median_mm": 24.0, "p90_mm": 44.0}]})"));
  state_widths(summary, 420.0);
  EXPECT_NEAR(json_of(summary)["by_distance"][0]["width_mm"].get<double>(), 1000.0 * 9 * 0.6 / 420.0, 1e-9)
      << "at the far end";
  summary.effective_frames = 12.5;
  EXPECT_EQ(json_of(summary)["effective_frames"], 12.5);
}

/// Levels and depths at random, some of them unknown.
struct RandomLevels {
  explicit RandomLevels(std::uint64_t seed) {
    Random random(seed);
    for (std::size_t i = 0; i < level_mm.size(); ++i) {
      depth_m[i] = random.uniform() < 0.1 ? 0.0F : static_cast<float>(random.uniform(0.2, 2.0));
      level_mm[i] = random.uniform() < 0.2 ? unknown : static_cast<float>(random.uniform(0.5, 30.0));
    }
  }
  Image<float> level_mm{60, 40};
  Image<float> depth_m{60, 40};
};

TEST(FindableShare, GrowsWithTheSizeUpToWhatIsJudged) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RandomLevels image(seed);
    for (const int window_px : {3, 7, 15}) {
      double less = 0.0;
      for (double size_mm = 1.0; size_mm < 100.0; size_mm *= 1.3) {
        const double share = findable_share(image.level_mm, image.depth_m, window_px, 425.0, size_mm);
        EXPECT_GE(share, less);
        EXPECT_LE(share, judged_share(image.level_mm));
        less = share;
      }
      EXPECT_GT(less, 0.5) << "all that is judged and has depth, in the end";
    }
  }
}

// The width of an object in the image is counted: pixels whose rays hit it.
TEST(FindableShare, CountsPixelsInWhichAnObjectIsHighAndWideEnough) {
  constexpr double focal_px = 425.0;
  constexpr int window_px = 7;
  const RandomLevels image(7);
  for (const FindableShare& findable : findable_shares(image.level_mm, image.depth_m, window_px, focal_px)) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.level_mm.size(); ++i) {
      if (std::isnan(image.level_mm[i]) || image.depth_m[i] == 0.0F) continue;
      const double width_px = findable.size_mm / 1000.0 / static_cast<double>(image.depth_m[i]) * focal_px;
      if (width_px < window_px || static_cast<double>(image.level_mm[i]) > findable.size_mm) continue;
      ++count;
    }
    EXPECT_GT(count, 0U) << findable.size_mm;
    EXPECT_EQ(findable.share, static_cast<double>(count) / 2400.0) << findable.size_mm;
  }
}

TEST(FindableShare, IsWrittenWhereItWasAskedFor) {
  DetectionLevelSummary summary{0.5, 9, 0.0, 0.0, std::nullopt, {}};
  EXPECT_FALSE(json_of(summary).contains("findable"));
  summary.findable = {{5.0, 0.25}, {10.0, 0.5}};
  EXPECT_EQ(
      json_of(summary)["findable"],
      nlohmann::ordered_json::parse(R"([{"size_mm": 5.0, "share": 0.25}, {"size_mm": 10.0, "share": 0.5}])"));
}

TEST(LevelOfDetection, IsDrawnBlackWhereItIsUnknown) {
  Image<float> level_mm(width, height, 9.0F);
  level_mm(30, 40) = unknown;
  level_mm(60, 40) = 1.0F;
  const ColorImage picture = draw_level_of_detection(level_mm);
  EXPECT_EQ(picture(30, 40), Rgb{});
  EXPECT_GT(picture(60, 40).b, picture(60, 40).r) << "little is blue";
  EXPECT_GT(picture(10, 40).r, picture(10, 40).b) << "much is red";
}

}  // namespace
}  // namespace rva
