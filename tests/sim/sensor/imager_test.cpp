#include "sim/sensor/imager.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace rva {
namespace {

constexpr int width = 300;
constexpr int height = 200;

ImagerLight flat(float steady, float projected) {
  return {Image<float>(width, height, steady), Image<float>(width, height, projected)};
}

ImagerLight evenly_spread_to(float brightest) {
  ImagerLight view = flat(0.0F, 0.0F);
  Random random(1);
  for (std::size_t i = 0; i < view.steady.size(); ++i) {
    view.steady[i] = 0.4F * brightest * static_cast<float>(random.uniform());
    view.projected[i] = 1.5F * view.steady[i];
  }
  return view;
}

StereoSensorOptions smooth() {
  StereoSensorOptions options;
  options.speckle = options.wander = options.levels = 0.0;
  return options;
}

InfraredImage exposed(const ImagerLight& view, double exposure_e, const StereoSensorOptions& options,
                      std::uint64_t seed = 1) {
  Speckle speckle(width, height, options, {{1, 1.0}}, 2);
  speckle.advance();
  return expose(view, speckle, exposure_e, options, seed);
}

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
};

Moments moments_of(const InfraredImage& image) {
  Moments moments;
  for (const std::uint16_t pixel : image.pixels()) moments.mean += pixel;
  moments.mean /= static_cast<double>(image.size());
  for (const std::uint16_t pixel : image.pixels())
    moments.variance += (pixel - moments.mean) * (pixel - moments.mean);
  moments.variance /= static_cast<double>(image.size());
  return moments;
}

TEST(Imager, NoiseIsShotNoiseReadNoiseAndRounding) {
  for (const double electrons : {100.0, 400.0, 1000.0}) {
    for (const double read_noise_e : {0.0, 6.0, 20.0}) {
      StereoSensorOptions options = smooth();
      options.read_noise_e = read_noise_e;
      const double levels_per_e = 1023.0 / options.full_well_e;
      const Moments moments = moments_of(exposed(flat(0.25F, 0.75F), electrons, options));
      const double variance_e = electrons + read_noise_e * read_noise_e;
      EXPECT_NEAR(moments.mean, electrons * levels_per_e, 0.5);
      const double expected = variance_e * levels_per_e * levels_per_e + 1.0 / 12.0;
      EXPECT_NEAR(moments.variance, expected, 0.05 * expected) << electrons << " " << read_noise_e;
    }
  }
}

TEST(Imager, FullIsFull) {
  EXPECT_EQ(exposed(flat(1.0F, 0.0F), 1e5, smooth()), InfraredImage(width, height, 1023));
  const InfraredImage nearly = exposed(flat(1.0F, 0.0F), 1490.0, smooth());
  EXPECT_EQ(*std::max_element(nearly.pixels().begin(), nearly.pixels().end()), 1023);
}

TEST(Imager, DarkIsNeverLessThanNothing) {
  StereoSensorOptions options = smooth();
  options.read_noise_e = 0.0;
  EXPECT_EQ(exposed(flat(0.0F, 0.0F), 1000.0, options), InfraredImage(width, height, 0));
  const Moments dark = moments_of(exposed(flat(0.0F, 0.0F), 1000.0, smooth()));
  EXPECT_GT(dark.mean, 0.5);
  EXPECT_LT(dark.mean, 6.0);
}

TEST(Imager, NoiseIsNewForEachSeedAndOnlyThen) {
  const ImagerLight view = flat(0.5F, 0.5F);
  const InfraredImage image = exposed(view, 400.0, smooth(), 1);
  EXPECT_EQ(image, exposed(view, 400.0, smooth(), 1));
  const InfraredImage other = exposed(view, 400.0, smooth(), 2);
  const double mean = moments_of(image).mean;
  double beside = 0.0;
  double later = 0.0;
  for (std::size_t i = 1; i < image.size(); ++i) {
    beside += (image[i] - mean) * (image[i - 1] - mean);
    later += (image[i] - mean) * (other[i] - mean);
  }
  const double variance = moments_of(image).variance * static_cast<double>(image.size());
  EXPECT_NEAR(beside / variance, 0.0, 0.025);
  EXPECT_NEAR(later / variance, 0.0, 0.025);
}

TEST(Imager, OnlyTheProjectorsLightSpeckles) {
  StereoSensorOptions options = smooth();
  options.speckle = 0.5;
  const InfraredImage even = exposed(flat(1.0F, 0.0F), 800.0, smooth());
  EXPECT_EQ(exposed(flat(1.0F, 0.0F), 800.0, options), even);
  EXPECT_GT(moments_of(exposed(flat(0.0F, 1.0F), 800.0, options)).variance, 5.0 * moments_of(even).variance);
}

TEST(AutomaticExposure, PutsTheBrighterPartsAtAQuarterOfTheWell) {
  for (const float brightest : {0.5F, 1.0F, 30.0F}) {
    for (const double full_well_e : {1000.0, 1500.0}) {
      StereoSensorOptions options;
      options.full_well_e = full_well_e;
      const double exposure_e = automatic_exposure(evenly_spread_to(brightest), options);
      // Light is spread evenly, so 95 % of the brightest is what 95 % of pixels are darker than.
      EXPECT_NEAR(exposure_e * 0.95 * static_cast<double>(brightest), full_well_e / 4,
                  0.01 * full_well_e / 4);
    }
  }
}

TEST(AutomaticExposure, AFewBrightPixelsDoNotCount) {
  ImagerLight view = flat(0.5F, 0.0F);
  const double exposure_e = automatic_exposure(view, {});
  std::fill_n(view.steady.pixels().begin(), view.steady.size() * 4 / 100, 1000.0F);
  EXPECT_EQ(automatic_exposure(view, {}), exposure_e);
}

TEST(AutomaticExposure, HasAnEndInTheDark) {
  const double longest_e = automatic_exposure(flat(0.0F, 0.0F), {});
  EXPECT_TRUE(std::isfinite(longest_e));
  EXPECT_EQ(automatic_exposure(flat(0.001F, 0.0F), {}), longest_e);
  EXPECT_EQ(automatic_exposure(flat(0.0F, 0.1F), {}), longest_e);
  EXPECT_LT(automatic_exposure(flat(0.0F, 1.0F), {}), longest_e);
}

}  // namespace
}  // namespace rva
