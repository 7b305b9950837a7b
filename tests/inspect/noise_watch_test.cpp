#include "inspect/noise_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "capture/capture.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace rva {
namespace {

constexpr int width = 160;
constexpr int height = 120;

CaptureInfo camera() {
  CaptureInfo info;
  info.depth = {width, height, 425.0, 425.0, 79.5, 59.5};
  info.depth_unit_m = 0.0001;
  info.camera = CameraInfo{"", "", 0.05};
  return info;
}

// A wall at a metre, with so much white noise.
NoiseSoFar watched(double std_mm, int frames) {
  NoiseWatch watch(camera());
  Random random(5);
  for (int k = 0; k < frames; ++k) {
    DepthImage frame(width, height);
    for (std::uint16_t& depth : frame.pixels())
      depth = static_cast<std::uint16_t>(std::lround(10000.0 + 10.0 * std_mm * random.normal()));
    watch.add(frame);
  }
  return watch.measure();
}

double median_level_mm(const NoiseSoFar& noise) { return noise.findable.by_distance.at(0).median_mm; }

TEST(NoiseWatch, MeasuresTheNoiseThatIsThere) {
  const NoiseSoFar noise = watched(3.0, 40);
  EXPECT_EQ(noise.frames, 40U);
  EXPECT_EQ(noise.measured, 1.0);
  EXPECT_NEAR(noise.median_std_mm, 3.0, 0.15);
}

TEST(NoiseWatch, MoreNoiseHidesLargerThingsAndMoreFramesShowSmaller) {
  EXPECT_GT(median_level_mm(watched(6.0, 40)), 1.5 * median_level_mm(watched(2.0, 40)));
  EXPECT_GT(median_level_mm(watched(3.0, 8)), 1.3 * median_level_mm(watched(3.0, 80)));
}

TEST(NoiseWatch, StatesInWhatShareObjectsWouldBeFound) {
  const std::vector<FindableShare> quiet = watched(2.0, 40).findable.findable;
  const std::vector<FindableShare> noisy = watched(100.0, 40).findable.findable;
  ASSERT_EQ(quiet.size(), findable_sizes_mm.size());
  for (std::size_t k = 0; k < quiet.size(); ++k) {
    EXPECT_EQ(quiet[k].size_mm, findable_sizes_mm[k]);
    EXPECT_LE(noisy[k].share, quiet[k].share);
  }
  EXPECT_GT(quiet.back().share, noisy.back().share + 0.5) << "20 mm drown in noise";
}

TEST(NoiseWatch, WhereNothingIsMeasuredNothingCouldBeFound) {
  NoiseWatch watch(camera());
  for (int k = 0; k < 4; ++k) watch.add(DepthImage(width, height));
  const NoiseSoFar noise = watch.measure();
  EXPECT_EQ(noise.measured, 0.0);
  EXPECT_EQ(noise.findable.judged, 0.0);
  EXPECT_TRUE(std::isnan(noise.least_mm(width / 2, height / 2)));
}

TEST(NoiseWatch, OfAFrozenCameraSaysSo) {
  const DepthImage wall(width, height, 10000);
  DepthImage other = wall;
  other(width - 1, height - 1) = 10001;
  NoiseWatch watch(camera());
  watch.add(wall);
  EXPECT_FALSE(watch.frozen()) << "one frame shows nothing";
  for (int k = 0; k < 5; ++k) watch.add(wall);
  EXPECT_TRUE(watch.frozen());
  watch.add(other);
  EXPECT_FALSE(watch.frozen());
  watch.add(wall);
  EXPECT_FALSE(watch.frozen()) << "once a frame differed, the camera was not frozen";
  NoiseWatch blind(camera());
  for (int k = 0; k < 4; ++k) blind.add(DepthImage(width, height));
  EXPECT_FALSE(blind.frozen()) << "that nothing is measured has another reason";
}

TEST(NoiseWatch, RefusesAFrameOfAnotherSize) {
  NoiseWatch watch(camera());
  EXPECT_THROW(watch.add(DepthImage(8, 6)), Error);
}

}  // namespace
}  // namespace rva
