#include "detect/calibrated/false_alarm_tail.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace rva {
namespace {

// Heights of peaks with a tail that is known: exp(-slope (h^shape - 3^shape)) beyond 3.
std::vector<float> peaks_of(int count, double slope, double shape, std::uint64_t seed) {
  std::vector<float> peaks;
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const double above = -std::log(1.0 - random.uniform()) / slope;
    peaks.push_back(static_cast<float>(std::pow(std::pow(3.0, shape) + above, 1.0 / shape)));
  }
  return peaks;
}

TEST(FalseAlarmTail, HeightAndNumberAreInversesOfEachOther) {
  const FalseAlarmTail tail(80.0, 0.7, 1.5);
  for (const double expected : {50.0, 1.0, 0.05, 1e-6}) {
    EXPECT_NEAR(tail.expected_above(tail.height_of(expected)), expected, 1e-9 * expected);
  }
  EXPECT_DOUBLE_EQ(tail.height_of(1000.0), FalseAlarmTail::onset);
}

TEST(FalseAlarmTail, NumbersTooSmallForADoubleStillRank) {
  const FalseAlarmTail tail(80.0, 1.0, 1.5);
  EXPECT_LT(tail.log10_expected_above(200.0), tail.log10_expected_above(100.0));
  EXPECT_TRUE(std::isfinite(tail.log10_expected_above(1000.0)));
}

TEST(FalseAlarmTail, LearnsTheTailOfItsPeaks) {
  for (const double slope : {0.1, 0.3, 0.5, 0.8, 1.2}) {
    const FalseAlarmTail tail = fit_tail(peaks_of(20000, slope, 1.5, 1), 1.5);
    const FalseAlarmTail truth(10000.0, slope, 1.5);
    EXPECT_NEAR(tail.height_of(1.0), truth.height_of(1.0), 0.05 * truth.height_of(1.0)) << slope;
  }
}

TEST(FalseAlarmTail, ChangesDoNotPassForNoise) {
  std::vector<float> peaks = peaks_of(200, 0.8, 1.5, 2);
  const double clean = fit_tail(peaks, 1.5).height_of(0.01);
  for (int i = 0; i < 40; ++i) peaks.push_back(10.0F + static_cast<float>(i));
  const double with_changes = fit_tail(peaks, 1.5).height_of(0.01);
  EXPECT_NEAR(with_changes, clean, 0.01 * clean);
}

TEST(FalseAlarmTail, WithoutPeaksTheUsualTailHolds) {
  const FalseAlarmTail tail = fit_tail({}, 1.5);
  EXPECT_GT(tail.height_of(0.01), 4.0);
  EXPECT_LT(tail.height_of(0.01), 7.0);
}

}  // namespace
}  // namespace rva
