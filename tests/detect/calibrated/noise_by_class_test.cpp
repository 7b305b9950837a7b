#include "detect/calibrated/noise_by_class.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/quantile.hpp"
#include "tests/detect/calibrated/noisy_captures.hpp"

namespace rva {
namespace {

double median_px(const NoiseByClass& noise, int first_column, int end_column) {
  std::vector<float> values;
  for (int v = 20; v < 220; ++v) {
    for (int u = first_column; u < end_column; ++u) values.push_back(noise.deviation_px(u, v));
  }
  return static_cast<double>(quantile(values, 0.5));
}

NoiseByClass noise_of(const DepthStatistics& before, const DepthStatistics& after) {
  const Image<float> none(before.width(), before.height());
  return noise_by_class(disparity_change(before, after, test::stereo), Mask(before.width(), before.height()),
                        none, none, test::stereo);
}

TEST(NoiseByClass, IsThatOfTheDifferenceOfMeans) {
  test::NoisyCapture capture;
  capture.frames = 16;
  capture.noise_px = 0.08;
  const NoiseByClass noise = noise_of(capture.take(1), capture.take(2));
  EXPECT_NEAR(median_px(noise, 20, 400), 0.08 * std::sqrt(2.0 / 16.0), 0.002);
}

TEST(NoiseByClass, FramesOfWhiteNoiseAreAllIndependent) {
  test::NoisyCapture capture;
  capture.frames = 16;
  // Pixels differ in noise, as real ones do: else the classes cannot be separated.
  const auto patched = [&](std::uint64_t seed) {
    DepthStatistics statistics(capture.width, capture.height);
    Random random(seed);
    for (int frame = 0; frame < capture.frames; ++frame) {
      DepthImage depth(capture.width, capture.height);
      for (int v = 0; v < capture.height; ++v) {
        for (int u = 0; u < capture.width; ++u) {
          const double noise_px = u < capture.width / 2 ? 0.05 : 0.15;
          depth(u, v) = static_cast<std::uint16_t>(
              std::lround(test::stereo.depth_m(25.0 + noise_px * random.normal()) / test::stereo.unit_m));
        }
      }
      statistics.add(depth);
    }
    return statistics;
  };
  const NoiseByClass noise = noise_of(patched(1), patched(2));
  ASSERT_TRUE(noise.effective_frames);
  EXPECT_NEAR(*noise.effective_frames, 16.0, 2.0);
  EXPECT_LT(noise.fixed_px, 0.02);
  EXPECT_GT(median_px(noise, 250, 400), 2.0 * median_px(noise, 20, 180));
}

TEST(NoiseByClass, ChangesInTheMinorityDoNotRaiseIt) {
  test::NoisyCapture capture;
  const DepthStatistics before = capture.take(1);
  capture.disparity_px = [](int u, int /*v*/) { return u < 80 ? 28.0 : 25.0; };
  const NoiseByClass noise = noise_of(before, capture.take(2));
  EXPECT_LT(median_px(noise, 120, 400), 1.4 * 0.05 * std::sqrt(2.0 / 10.0));
}

TEST(NoiseByClass, UnreliablePixelsHaveANoiseOfTheirOwn) {
  test::NoisyCapture capture;
  const DisparityChange still = disparity_change(capture.take(1), capture.take(2), test::stereo);
  DisparityChange change = still;
  Mask unreliable(capture.width, capture.height);
  for (int v = 0; v < capture.height; ++v) {
    for (int u = 0; u < 100; ++u) {
      unreliable(u, v) = mask_set;
      change.after_px(u, v) = still.before_px(u, v) + 4.0F * (still.after_px(u, v) - still.before_px(u, v));
    }
  }
  const Image<float> none(capture.width, capture.height);
  const NoiseByClass noise = noise_by_class(change, unreliable, none, none, test::stereo);
  EXPECT_NEAR(median_px(noise, 20, 90) / median_px(noise, 120, 400), 4.0, 0.8);
}

TEST(NoiseByClass, RoundingOfDepthIsNoise) {
  test::NoisyCapture capture;
  capture.noise_px = 0.0;
  const NoiseByClass noise = noise_of(capture.take(1), capture.take(2));
  // 0.1 mm at 0.85 m is 0.0029 px, of which a uniform distribution has 1 / sqrt(12) on either side.
  EXPECT_NEAR(median_px(noise, 20, 400), 0.00294 / std::sqrt(6.0), 0.0001);
}

}  // namespace
}  // namespace rva
