#include "detect/calibrated/false_alarm_tail.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace rva {
namespace {

// Heights of peaks with a tail that is known: exp(-slope (h - 3)) beyond 3.
std::vector<float> peaks_of(int count, double slope, std::uint64_t seed) {
  std::vector<float> peaks;
  Random random(seed);
  for (int i = 0; i < count; ++i)
    peaks.push_back(static_cast<float>(3.0 - std::log(1.0 - random.uniform()) / slope));
  return peaks;
}

TEST(FalseAlarmTail, HeightAndNumberAreInversesOfEachOther) {
  const FalseAlarmTail tail(80.0, 1.7, 30.0);
  for (const double expected : {50.0, 1.0, 0.05, 1e-6}) {
    EXPECT_NEAR(tail.expected_above(tail.height_of(expected)), expected, 1e-9 * expected);
  }
  EXPECT_DOUBLE_EQ(tail.height_of(1000.0), FalseAlarmTail::onset);
}

TEST(FalseAlarmTail, IsExponentialForManyPeaksAndHeavierForFew) {
  EXPECT_NEAR(FalseAlarmTail(80.0, 2.0, 1e9).expected_above(6.0), 80.0 * std::exp(-6.0), 1e-6);
  EXPECT_GT(FalseAlarmTail(80.0, 2.0, 10.0).expected_above(6.0), 80.0 * std::exp(-6.0));
}

TEST(FalseAlarmTail, NumbersTooSmallForADoubleStillRank) {
  const FalseAlarmTail tail(80.0, 2.0, 1e6);
  EXPECT_EQ(tail.expected_above(1000.0), 0.0);
  EXPECT_LT(tail.log10_expected_above(2000.0), tail.log10_expected_above(1000.0));
}

TEST(FalseAlarmTail, LearnsTheTailOfItsPeaks) {
  for (const double slope : {0.4, 0.8, 1.2, 2.0, 4.0}) {
    const FalseAlarmTail tail = fit_tail(peaks_of(20000, slope, 1), {1.5});
    const FalseAlarmTail truth(10000.0, slope, 1e9);
    EXPECT_NEAR(tail.height_of(1.0), truth.height_of(1.0), 0.05 * truth.height_of(1.0)) << slope;
  }
}

// What is learnt from 30 peaks must hold for 30 others: 0.1 of either sign are 0.2 of both beyond the height.
TEST(FalseAlarmTail, KeepsItsRateOnAverageWithFewPeaks) {
  constexpr int repetitions = 4000;
  int beyond = 0;
  for (std::uint64_t seed = 0; seed < repetitions; ++seed) {
    const float height = static_cast<float>(fit_tail(peaks_of(30, 1.5, 2 * seed), {1.5}).height_of(0.1));
    for (const float peak : peaks_of(30, 1.5, 2 * seed + 1)) beyond += peak > height ? 1 : 0;
  }
  EXPECT_GT(beyond, 0.1 * repetitions);
  EXPECT_LT(beyond, 0.3 * repetitions);
}

// The slope of an image, gamma distributed about the prior one.
double slope_of(const PriorSlope& prior, Random& random) {
  double sum = 0.0;  // of as many exponential numbers as the prior slope counts peaks
  for (int k = 0; k < static_cast<int>(prior.peaks); ++k) sum -= std::log(1.0 - random.uniform());
  return sum * prior.slope / prior.peaks;
}

// Where peaks are as the tail assumes, the thresholds of many images let through what is allowed on average,
// also if excesses are truncated so early that each of them contains little about the slope.
TEST(FalseAlarmTail, LetsThroughOnAverageWhatIsAllowed) {
  constexpr int images = 3000;
  constexpr int peaks = 120;
  constexpr double allowed = 0.05 / 16.0;
  struct Case {
    PriorSlope prior;
    double end;
    double at_most;  // of what is allowed: the shorter, the less is the posterior a gamma distribution
  };
  for (const auto& [prior, end, at_most] :
       {Case{{1.3, 10.0}, 7.0, 1.4}, Case{{1.25, 7.0}, 7.0, 1.4}, Case{{1.7, 7.0}, 5.0, 1.8}}) {
    Random random(17);
    double expected = 0.0;
    for (std::uint64_t image = 0; image < images; ++image) {
      const double slope = slope_of(prior, random);
      const double height = fit_tail(peaks_of(peaks, slope, 1000 + image), prior, end).height_of(allowed);
      expected += 0.5 * peaks * std::exp(-slope * (height - FalseAlarmTail::onset)) / images;
    }
    EXPECT_GT(expected, 0.6 * allowed) << prior.slope << " up to " << end;
    EXPECT_LT(expected, at_most * allowed) << prior.slope << " up to " << end;
  }
}

TEST(FalseAlarmTail, ChangesDoNotPassForNoise) {
  std::vector<float> peaks = peaks_of(200, 1.8, 2);
  const double clean = fit_tail(peaks, {1.5}).height_of(0.01);
  for (int i = 0; i < 40; ++i) peaks.push_back(10.0F + static_cast<float>(i));
  const double with_changes = fit_tail(peaks, {1.5}).height_of(0.01);
  EXPECT_NEAR(with_changes, clean, 0.01 * clean);
}

TEST(FalseAlarmTail, WithoutPeaksThePriorTailIsUsed) {
  const FalseAlarmTail tail = fit_tail({}, {2.0});
  EXPECT_NEAR(tail.height_of(0.01), FalseAlarmTail(0.5, 2.0, 10.0).height_of(0.01), 1e-9);
  const FalseAlarmTail flat = fit_tail({6.9F, 6.9F}, {2.0});
  EXPECT_GT(flat.height_of(0.01), tail.height_of(0.01)) << "two peaks count";
  EXPECT_LT(flat.height_of(0.01), 30.0) << "but no more";
}

TEST(FalseAlarmTail, ASlopeThatIsKnownWellNeedsNoReserve) {
  const std::vector<float> steep = peaks_of(10, 6.0, 3);
  const double doubted = fit_tail(steep, {2.0, 10.0}).height_of(0.01);
  const double known = fit_tail(steep, {2.0, 1e6}).height_of(0.01);
  EXPECT_NEAR(known, FalseAlarmTail(5.0, 2.0, 1e6).height_of(0.01), 0.01) << "what was learnt does not count";
  EXPECT_LT(fit_tail({}, {2.0, 1e6}).height_of(0.01), fit_tail({}, {2.0, 10.0}).height_of(0.01));
  EXPECT_NE(doubted, known);
}

}  // namespace
}  // namespace rva
