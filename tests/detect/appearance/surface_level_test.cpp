#include "detect/appearance/surface_level.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/stereo_scale.hpp"

namespace rva {
namespace {

constexpr StereoScale stereo{.focal_baseline_m_px = 20.0};
constexpr double false_findings = 0.05;
constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

// Four pixels at one metre: a level of depth that surfaces better, one that they do not, and two without.
struct Levels {
  Levels() {
    light.surface.judged = Mask(4, 1, mask_set);
    light.surface.deviations_per_px = Image<float>(4, 1, 40.0F);
    light.surface.deviations_per_px(3, 0) = 1.0F;
    detection.final_m = Image<float>(4, 1, 1.0F);
    detection.level_of_detection = LevelOfDetection{Image<float>(4, 1, unknown), {}};
    detection.level_of_detection->least_mm(0, 0) = 100.0F;
    detection.level_of_detection->least_mm(1, 0) = 1.0F;
  }

  void lower() { lower_level_of_detection(light, false_findings, stereo, detection); }
  [[nodiscard]] float at(int u) const { return detection.level_of_detection->least_mm(u, 0); }

  JudgedChange light{.change = {}, .tail = FalseAlarmTail(40.0, 2.0, 40.0)};
  Detection detection;
};

TEST(SurfaceLevel, IsTheLesserOfBothAndFillsInWhereDepthHasNone) {
  Levels levels;
  levels.lower();
  // The threshold's deviations at 40 a pixel; a pixel of disparity is 50 mm at one metre.
  const double needed = levels.light.tail.height_of(0.5 * false_findings) + nine_of_ten_deviations;
  const auto expected_mm = static_cast<float>(needed / 40.0 * 50.0);
  EXPECT_FLOAT_EQ(levels.at(0), expected_mm);
  EXPECT_FLOAT_EQ(levels.at(1), 1.0F);
  EXPECT_FLOAT_EQ(levels.at(2), expected_mm);
  EXPECT_TRUE(std::isnan(levels.at(3))) << "a pixel and more is beyond what small changes foretell";
  EXPECT_EQ(levels.detection.level_of_detection->summary.judged, 0.75);
  EXPECT_GE(levels.detection.level_of_detection->summary.window_px, surface_window_px);
}

TEST(SurfaceLevel, LeavesOutWhatAPersonLeftOut) {
  Levels levels;
  levels.detection.left_out = Mask(4, 1);
  levels.detection.left_out(2, 0) = mask_set;
  levels.lower();
  EXPECT_TRUE(std::isnan(levels.at(2)));
}

TEST(SurfaceLevel, StaysAsItWasWithoutSurfaces) {
  Levels levels;
  levels.light.surface = {};
  levels.lower();
  EXPECT_EQ(levels.at(0), 100.0F);
  EXPECT_TRUE(std::isnan(levels.at(2)));
}

}  // namespace
}  // namespace rva
