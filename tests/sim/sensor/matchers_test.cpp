// The matchers of cameras of other kinds, held against what a wall of known disparity shows.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/error.hpp"
#include "sim/sensor/camera_models.hpp"
#include "sim/sensor/stereo_sensor.hpp"
#include "stereo/correlation.hpp"
#include "stereo/semi_global.hpp"
#include "tests/stereo/random_images.hpp"

namespace rva {
namespace {

constexpr int width = 220;
constexpr int height = 60;
constexpr int border_px = 14;

struct Answers {
  double matched = 0.0;  // share
  double mean_error_px = 0.0;
  double wrong = 0.0;  // share of the matched that is off by more than a pixel
};

// Of the middle of a wall that lies `disparity_px` away.
Answers answers(const StereoSensorOptions& sensor, double disparity_px) {
  const test::BlobTexture texture(width, height, 1.2, 1);
  const Image<std::uint16_t> found =
      match_stereo(texture.seen(width, height, 0.0), texture.seen(width, height, disparity_px), sensor);
  Answers result;
  int pixels = 0;
  int matched = 0;
  for (int v = border_px; v < height - border_px; ++v) {
    for (int u = 70; u < width - border_px; ++u) {
      ++pixels;
      if (found(u, v) == 0) continue;
      ++matched;
      const double error_px = found(u, v) / 32.0 - disparity_px;
      if (std::abs(error_px) > 1.0)
        result.wrong += 1.0;
      else
        result.mean_error_px += error_px;
    }
  }
  result.matched = static_cast<double>(matched) / pixels;
  result.mean_error_px /= std::max(1, matched);
  result.wrong /= std::max(1, matched);
  return result;
}

TEST(Matchers, OfEveryModelMeasureAWall) {
  for (const CameraModel& model : camera_models()) {
    for (const double disparity_px : {20.0, 33.3, 41.75}) {
      const Answers wall = answers(model.sensor, disparity_px);
      EXPECT_GT(wall.matched, 0.8) << model.name << " " << disparity_px;
      EXPECT_LT(std::abs(wall.mean_error_px), 0.15) << model.name << " " << disparity_px;
      EXPECT_LT(wall.wrong, 0.01) << model.name << " " << disparity_px;
    }
  }
}

// Shimizu and Okutomi, ICCV 2001: between whole pixels the answers lean towards the nearer one.
TEST(Matchers, ThatFitAParabolaAreDrawnTowardsWholePixels) {
  StereoSensorOptions sensor;
  sensor.matcher = Matcher::correlation;
  EXPECT_LT(answers(sensor, 30.25).mean_error_px, -0.01);
  EXPECT_GT(answers(sensor, 30.75).mean_error_px, 0.01);
  EXPECT_LT(std::abs(answers({}, 30.25).mean_error_px), 0.5 * std::abs(answers(sensor, 30.25).mean_error_px))
      << "least squares hardly are";
}

TEST(Matchers, GiveTheSameWhateverTheNumberOfRows) {
  const test::BlobTexture texture(width, height, 1.2, 1);
  const InfraredImage left = texture.seen(width, height, 0.0);
  const InfraredImage right = texture.seen(width, height, 33.3);
  EXPECT_EQ(match_semi_globally(left, right), match_semi_globally(left, right));
  EXPECT_EQ(match_by_correlation(left, right), match_by_correlation(left, right));
}

TEST(Matchers, FindNothingWhereThereIsNothing) {
  const InfraredImage flat(width, height, 300);
  for (const Image<std::uint16_t>& found :
       {match_semi_globally(flat, flat), match_by_correlation(flat, flat)}) {
    for (std::size_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i], 0) << i;
  }
}

TEST(CameraModels, DrawnByChanceAreAllowedAndDiffer) {
  std::set<std::string> matchers;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const StereoSensorOptions sensor = random_camera(seed);
    EXPECT_NO_THROW(check_options(sensor));
    EXPECT_EQ(sensor.window_px % 2, 1);
    matchers.insert(name_of_matcher(sensor));
    EXPECT_EQ(sensor.focal_px, camera_model("random:" + std::to_string(seed)).focal_px);
  }
  EXPECT_EQ(matchers.size(), 11U) << "five windows of two matchers, and one that has none";
}

TEST(CameraModels, ImperfectOnesAreTheDrawnOnesWithFlaws) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const StereoSensorOptions sensor = imperfect_camera(seed);
    EXPECT_NO_THROW(check_options(sensor));
    EXPECT_GT(sensor.rectification_px, 0.0);
    EXPECT_EQ(sensor.focal_px, random_camera(seed).focal_px);
    EXPECT_EQ(sensor.sway_mm, camera_model("imperfect:" + std::to_string(seed)).sway_mm);
  }
}

TEST(CameraModels, AStudyDrawsAnotherForEachInspection) {
  for (const char* const text : {"random:3", "imperfect:3"}) {
    const auto camera = camera_of_each(text);
    EXPECT_EQ(camera(1).focal_px, camera(1).focal_px);
    EXPECT_NE(camera(1).focal_px, camera(2).focal_px);
    EXPECT_NE(camera(1).focal_px, camera_model(text).focal_px) << "the seed counts, too";
  }
  EXPECT_EQ(camera_of_each("census-5")(1).window_px, camera_of_each("census-5")(2).window_px);
  EXPECT_THROW((void)camera_of_each("random:x"), UsageError);
}

TEST(CameraModels, UnknownOnesAreRefused) {
  for (const char* const text : {"", "D435", "random", "random:", "random:x", "random:1 ", "random:-1",
                                 "imperfect", "imperfect:", "imperfect:99999999999999999999"})
    EXPECT_THROW((void)camera_model(text), UsageError) << text;
}

}  // namespace
}  // namespace rva
