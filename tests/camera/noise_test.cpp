#include "camera/noise.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/error.hpp"
#include "tests/depth/stacks.hpp"

namespace rva {
namespace {

// Student's t density integrated numerically (Simpson), as a reference that shares nothing with the code.
double two_sided_p(double t, double degrees_of_freedom) {
  const double nu = degrees_of_freedom;
  const double scale =
      std::exp(std::lgamma((nu + 1) / 2) - std::lgamma(nu / 2)) / std::sqrt(nu * std::numbers::pi);
  const auto density = [&](double x) { return scale * std::pow(1 + x * x / nu, -(nu + 1) / 2); };
  constexpr int steps = 20000;
  const double width = std::abs(t) / steps;
  double inside = density(0) + density(std::abs(t));
  for (int k = 1; k < steps; ++k) inside += (k % 2 == 1 ? 4 : 2) * density(k * width);
  return 1.0 - 2.0 * inside * width / 3.0;
}

DepthStatistics statistics_of(const std::vector<int>& depths) {
  DepthStatistics statistics(1, 1);
  for (const int depth : depths) statistics.add(DepthImage(1, 1, static_cast<std::uint16_t>(depth)));
  return statistics;
}

double variance(const std::vector<int>& values, double mean) {
  double sum = 0;
  for (const int value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<double>(values.size() - 1);
}

double mean_of(const std::vector<int>& values) {
  double sum = 0;
  for (const int value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(Noise, OfAFrozenCameraIsRefused) {
  const test::MemoryCapture frozen = test::capture_of(std::vector<DepthImage>(6, DepthImage(8, 6, 1000)));
  EXPECT_THAT([&] { static_cast<void>(measure_noise(frozen, {}, {})); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("the camera was frozen")));
}

TEST(WelchTest, AgreesWithTheTextbook) {
  const std::vector<std::pair<std::vector<int>, std::vector<int>>> cases{
      {{1000, 1002, 1001, 999}, {1003, 1005, 1004, 1009, 1002}},
      {{500, 501}, {500, 505, 499}},
      {{2000, 2010, 1990, 2005, 1995, 2001}, {2001, 2002, 2000, 2001}},
  };
  for (const auto& [a, b] : cases) {
    const double from_a = variance(a, mean_of(a)) / static_cast<double>(a.size());
    const double from_b = variance(b, mean_of(b)) / static_cast<double>(b.size());
    const double t = (mean_of(a) - mean_of(b)) / std::sqrt(from_a + from_b);
    const double nu = (from_a + from_b) * (from_a + from_b) /
                      (from_a * from_a / static_cast<double>(a.size() - 1) +
                       from_b * from_b / static_cast<double>(b.size() - 1));
    const double p = welch_p_value(statistics_of(a), statistics_of(b), 0);
    EXPECT_NEAR(p, two_sided_p(t, nu), 1e-9);
    EXPECT_DOUBLE_EQ(p, welch_p_value(statistics_of(b), statistics_of(a), 0));
  }
}

TEST(WelchTest, ConstantPixelsDifferOrNot) {
  EXPECT_EQ(welch_p_value(statistics_of({5, 5}), statistics_of({5, 5, 5}), 0), 1.0);
  EXPECT_EQ(welch_p_value(statistics_of({5, 5}), statistics_of({6, 6, 6}), 0), 0.0);
}

TEST(WelchTest, NeedsTwoMeasurementsOnEitherSide) {
  EXPECT_TRUE(std::isnan(welch_p_value(statistics_of({5, 0}), statistics_of({6, 6}), 0)));
  EXPECT_TRUE(std::isnan(welch_p_value(statistics_of({5, 6}), statistics_of({6}), 0)));
}

std::vector<DepthImage> white_noise(int frames, double mean, double sigma, double step_after_half) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0.0, sigma);
  std::vector<DepthImage> stack;
  for (int k = 0; k < frames; ++k) {
    DepthImage frame(100, 100);
    const double level = mean + (k < frames / 2 ? 0.0 : step_after_half);
    for (std::uint16_t& depth : frame.pixels())
      depth = static_cast<std::uint16_t>(std::lround(level + normal(random)));
    stack.push_back(std::move(frame));
  }
  return stack;
}

TEST(Noise, WelchRejectsItsAlphaOfWhiteNoise) {
  const Noise noise = measure_noise(test::capture_of(white_noise(40, 10000, 20, 0)), {}, {});
  ASSERT_EQ(noise.report.welch_tested_px, 10000U);
  // 10,000 independent trials at 0.01: 5 binomial deviations are 0.005.
  EXPECT_NEAR(noise.report.welch_rejected, 0.01, 0.005);
}

TEST(Noise, WelchSeesAStep) {
  const Noise noise = measure_noise(test::capture_of(white_noise(40, 10000, 20, 60)), {}, {});
  EXPECT_GT(noise.report.welch_rejected, 0.99);
}

TEST(Noise, DeviationIsInMillimetresAndInDisparity) {
  CaptureInfo info = test::info_of(100, 100);
  info.depth_unit_m = 0.0001;
  info.camera = CameraInfo{"", "", 0.05};
  const double sigma_units = 20.0;
  const test::MemoryCapture capture(info, white_noise(60, 10000, sigma_units, 0));
  const NoiseReport report = measure_noise(capture, {}, {}).report;
  EXPECT_NEAR(report.overall.median_std_mm, 2.0, 0.04);
  EXPECT_GT(report.overall.p95_std_mm, report.overall.median_std_mm);
  // At z = 1 m: 2 mm * f B / z^2 = 0.002 * 425 * 0.05.
  EXPECT_NEAR(*report.overall.subpixel_rms_px, 0.0425, 0.001);
  // The depth of 1 m is the border of two classes; every pixel is in one of them.
  std::size_t pixels = 0;
  for (const NoiseBin& bin : report.bins) pixels += bin.pixels;
  EXPECT_EQ(pixels, 10000U);
}

TEST(Noise, NoBaselineNoDisparity) {
  const NoiseReport report = measure_noise(test::capture_of(white_noise(8, 1000, 2, 0)), {}, {}).report;
  EXPECT_FALSE(report.overall.subpixel_rms_px);
  EXPECT_EQ(report.welch_frames, 4U);
  EXPECT_EQ(report.fill_rate, 1.0);
}

TEST(Noise, HolesAreCountedAndLeftOut) {
  std::vector<DepthImage> stack(8, DepthImage(2, 1, 1000));
  for (std::size_t k = 0; k < 7; ++k) stack[k](1, 0) = no_depth;
  const Noise noise = measure_noise(test::capture_of(stack), {}, {});
  EXPECT_DOUBLE_EQ(noise.report.fill_rate, 9.0 / 16.0);
  EXPECT_EQ(noise.std_mm[0], 0.0F);
  EXPECT_TRUE(std::isnan(noise.std_mm[1]));
  EXPECT_EQ(noise.report.welch_tested_px, 1U);
}

TEST(Noise, ThreeFramesAreTooFew) {
  EXPECT_THROW(static_cast<void>(measure_noise(test::capture_of(white_noise(3, 1000, 2, 0)), {}, {})), Error);
}

}  // namespace
}  // namespace rva
