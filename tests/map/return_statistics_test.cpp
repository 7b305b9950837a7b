#include "map/return_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/random.hpp"

namespace rva {
namespace {

bool covers(const Estimated& estimated, double truth) {
  return estimated.low <= truth && truth <= estimated.high;
}

Groups drawn(std::size_t groups, std::size_t each, const std::function<double()>& draw) {
  Groups result(groups);
  for (std::vector<double>& values : result) {
    for (std::size_t i = 0; i < each; ++i) values.push_back(draw());
  }
  return result;
}

TEST(PooledDeviation, IsThatOfATextbook) {
  const Estimated deviation = pooled_deviation({{1.0, 3.0}, {10.0, 12.0}});
  EXPECT_NEAR(deviation.value, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(deviation.low, std::sqrt(4.0 / 7.3777589), 1e-6);  // quantiles of chi-square, two degrees
  EXPECT_NEAR(deviation.high, std::sqrt(4.0 / 0.0506356), 1e-4);
}

TEST(PooledDeviation, IsNotAffectedByTheMeansOfTheGroupsAndScalesWithTheValues) {
  const Estimated deviation = pooled_deviation({{1.0, 2.0, 4.0}, {7.0, 7.5}});
  const Estimated moved = pooled_deviation({{-9.0, -8.0, -6.0}, {107.0, 107.5}});
  const Estimated doubled = pooled_deviation({{2.0, 4.0, 8.0}, {14.0, 15.0}});
  EXPECT_NEAR(moved.value, deviation.value, 1e-12);
  EXPECT_NEAR(doubled.low, 2.0 * deviation.low, 1e-12);
  EXPECT_NEAR(doubled.high, 2.0 * deviation.high, 1e-12);
}

TEST(PooledDeviation, OfEqualValuesIsZero) {
  const Estimated deviation = pooled_deviation({{0.5, 0.5, 0.5}});
  EXPECT_EQ(deviation.value, 0.0);
  EXPECT_EQ(deviation.high, 0.0);
}

TEST(PooledDeviation, HasAnIntervalThatCoversTheTruthAsOftenAsItStates) {
  Random random(11);
  constexpr int trials = 2000;
  int normal = 0;
  int even = 0;
  for (int i = 0; i < trials; ++i) {
    normal += covers(pooled_deviation(drawn(3, 5, [&] { return 0.1 * random.normal(); })), 0.1) ? 1 : 0;
    const double half = 0.1 * std::sqrt(3.0);
    even += covers(pooled_deviation(drawn(3, 5, [&] { return random.uniform(-half, half); })), 0.1) ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(normal) / trials, 0.95, 0.015);
  EXPECT_GT(static_cast<double>(even) / trials, 0.97);
}

TEST(MeanDifference, IsTheMeanOfTheDifferencesOfAllPoses) {
  const Estimated difference = mean_difference({{0.0, 2.0}, {5.0}}, {{3.0}, {6.0, 8.0}});
  EXPECT_NEAR(difference.value, 2.0, 1e-12);  // 2 at the first pose, 2 at the second
  const Estimated reversed = mean_difference({{3.0}, {6.0, 8.0}}, {{0.0, 2.0}, {5.0}});
  EXPECT_NEAR(reversed.value, -2.0, 1e-12);
  EXPECT_NEAR(reversed.low, -difference.high, 1e-12);
}

TEST(MeanDifference, HasAnIntervalThatCoversTheTruthAsOftenAsItStates) {
  Random random(12);
  constexpr int trials = 2000;
  int covered = 0;
  for (int i = 0; i < trials; ++i) {
    const Groups smaller = drawn(3, 4, [&] { return 0.1 * random.normal(); });
    const Groups larger = drawn(3, 4, [&] { return 0.3 + 0.1 * random.normal(); });
    covered += covers(mean_difference(smaller, larger), 0.3) ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(covered) / trials, 0.95, 0.015);
}

TEST(Largest, IsThatOfEitherSign) {
  EXPECT_EQ(largest({{0.1, -0.4}, {}, {0.3}}), 0.4);
  EXPECT_EQ(largest({}), 0.0);
}

}  // namespace
}  // namespace rva
