#include "sim/sensor/stereo_sensor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/stereo/random_images.hpp"

namespace rva {
namespace {

Image<std::uint16_t> all_disparities() {
  Image<std::uint16_t> disparities(256, 256);
  for (std::size_t i = 0; i < disparities.size(); ++i) disparities[i] = static_cast<std::uint16_t>(i);
  return disparities;
}

void expect_depths(const StereoSensorOptions& options) {
  const DepthImage depth = depth_from_disparity(all_disparities(), options);
  EXPECT_EQ(depth[0], no_depth);
  for (std::size_t i = 1; i < depth.size(); ++i) {
    const double disparity_px = static_cast<double>(i) / 32.0;
    const double units = options.focal_px * options.baseline_mm / disparity_px / options.depth_unit_mm;
    if (std::round(units) > 65535.0) {
      ASSERT_EQ(depth[i], no_depth) << i;
    } else {
      ASSERT_NEAR(depth[i], units, 0.5 + 1e-6) << i;
    }
  }
}

TEST(DepthFromDisparity, IsFocalLengthTimesBaselineOverDisparity) {
  expect_depths({});
  StereoSensorOptions other;
  other.focal_px = 640.0;
  other.baseline_mm = 95.0;
  other.depth_unit_mm = 1.0;
  expect_depths(other);
}

TEST(DepthFromDisparity, WhatDoesNotFitIsNoDepth) {
  const DepthImage depth = depth_from_disparity(all_disparities(), {});
  EXPECT_EQ(depth[103], no_depth);
  EXPECT_EQ(depth[104], 65385);
}

TEST(DepthFromDisparity, KeepsTheImagesShape) {
  Image<std::uint16_t> disparity(5, 3);
  disparity(4, 1) = 680;  // 21.25 px: 1 m
  const DepthImage depth = depth_from_disparity(disparity, {});
  ASSERT_TRUE(depth.same_size(disparity));
  EXPECT_EQ(depth(4, 1), 10000);
  EXPECT_EQ(std::count(depth.pixels().begin(), depth.pixels().end(), no_depth), 14);
}

TEST(MatchStereo, MeasuresAWall) {
  const test::BlobTexture texture(200, 60, 1.2, 1);
  const Image<std::uint16_t> disparity =
      match_stereo(texture.seen(200, 60, 0.0), texture.seen(200, 60, 33.3));
  for (int v = 6; v < 54; ++v) {
    for (int u = 60; u < 190; ++u) ASSERT_NEAR(disparity(u, v) / 32.0, 33.3, 0.3) << u << " " << v;
  }
}

class Sensor : public testing::Test {
 protected:
  const std::vector<SpeckleShare> speckle_{{1, 1.0}};
  static InfraredPair wall() {
    const test::BlobTexture texture(200, 60, 1.2, 1);
    const auto view = [](const InfraredImage& image) {
      ImagerLight light{Image<float>(200, 60), Image<float>(200, 60)};
      for (std::size_t i = 0; i < image.size(); ++i)
        light.projected[i] = static_cast<float>(image[i]) / 400.0F;
      return light;
    };
    return {view(texture.seen(200, 60, 0.0)), view(texture.seen(200, 60, 21.25))};
  }
  static double mean_of(const InfraredImage& image) {
    double sum = 0.0;
    for (const std::uint16_t pixel : image.pixels()) sum += pixel;
    return sum / static_cast<double>(image.size());
  }
};

TEST_F(Sensor, SeedsMakeItsFrames) {
  StereoSensor sensor(wall(), {}, speckle_, 2);
  StereoSensor same(wall(), {}, speckle_, 2);
  StereoSensor other(wall(), {}, speckle_, 3);
  for (int k = 0; k < 3; ++k) {
    const StereoFrame frame = sensor.next_frame();
    const StereoFrame again = same.next_frame();
    EXPECT_EQ(frame.left, again.left);
    EXPECT_EQ(frame.right, again.right);
    EXPECT_EQ(frame.depth, again.depth);
    EXPECT_NE(frame.left, other.next_frame().left);
    EXPECT_EQ(frame.depth, depth_from_disparity(match_stereo(frame.left, frame.right), {}));
    EXPECT_NEAR(frame.depth(100, 30), 10000, 400);
  }
}

TEST_F(Sensor, TheWholeFrameFlickers) {
  StereoSensorOptions options;
  options.speckle = options.wander = options.levels = 0.0;
  for (const double flicker : {0.0, 0.02}) {
    options.flicker = flicker;
    StereoSensor sensor(wall(), options, speckle_, 2);
    double sum = 0.0;
    double squares = 0.0;
    constexpr int frames = 30;
    for (int k = 0; k < frames; ++k) {
      const double mean = mean_of(sensor.next_frame().left);
      sum += mean / frames;
      squares += mean * mean / frames;
    }
    EXPECT_NEAR(std::sqrt(squares - sum * sum) / sum, flicker, 0.3 * flicker + 0.002);
  }
}

TEST_F(Sensor, TheRightImagerMayRecordMoreLight) {
  StereoSensorOptions options;
  options.speckle = options.wander = options.levels = 0.0;
  const auto ratio = [&] {
    const StereoFrame frame = StereoSensor(wall(), options, speckle_, 2).next_pair();
    return mean_of(frame.right) / mean_of(frame.left);
  };
  const double alike = ratio();
  options.imager_difference = -0.2;
  EXPECT_NEAR(ratio() / alike, 0.8, 0.01);
}

TEST_F(Sensor, TheTargetSaysHowBrightAnExposureIs) {
  StereoSensorOptions options;
  const double quarter_e = automatic_exposure(wall().left, options);
  options.exposure_target = 0.125;
  EXPECT_NEAR(automatic_exposure(wall().left, options), 0.5 * quarter_e, 1e-9 * quarter_e);
}

TEST_F(Sensor, ExposureIsAutomaticUntilItIsSet) {
  StereoSensorOptions options;
  const double automatic = mean_of(StereoSensor(wall(), options, speckle_, 2).next_frame().left);
  options.exposure = automatic_exposure(wall().left, options);
  EXPECT_NEAR(mean_of(StereoSensor(wall(), options, speckle_, 2).next_frame().left), automatic, 1e-9);
  options.exposure /= 2.0;
  EXPECT_NEAR(mean_of(StereoSensor(wall(), options, speckle_, 2).next_frame().left), automatic / 2.0,
              0.02 * automatic);
}

}  // namespace
}  // namespace rva
