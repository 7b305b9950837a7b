#include "evaluate/probability_of_detection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace rva {
namespace {

constexpr double true_a50_mm = 8.0;
constexpr double true_slope = 6.0;
// Where ln 9 is reached.
const double true_a90_mm = true_a50_mm * std::exp(std::log(9.0) / true_slope);

std::vector<DetectionTrial> drawn(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<DetectionTrial> trials;
  while (trials.size() < count) {
    const double size_mm = random.uniform(4.0, 20.0);
    const double logit = true_slope * std::log(size_mm / true_a50_mm);
    trials.push_back({size_mm, random.uniform() < 1.0 / (1.0 + std::exp(-logit))});
  }
  return trials;
}

TEST(DetectionSizes, OfManyTrialsAreThoseOfTheCurve) {
  const auto sizes = fit_detection_sizes(drawn(3000, 1));
  ASSERT_TRUE(sizes);
  EXPECT_NEAR(sizes->a50_mm, true_a50_mm, 0.05 * true_a50_mm);
  EXPECT_NEAR(sizes->a90_mm, true_a90_mm, 0.05 * true_a90_mm);
  ASSERT_TRUE(sizes->a90_95_mm);
  EXPECT_GT(*sizes->a90_95_mm, sizes->a90_mm);
  EXPECT_LT(*sizes->a90_95_mm, 1.1 * sizes->a90_mm);
}

// 95 of 100 bounds lie above the truth: 179 to 199 of 200 in more than 999 of 1000 such tests.
TEST(DetectionSizes, TheBoundHoldsNineteenTimesOfTwenty) {
  int held = 0;
  constexpr int studies = 200;
  for (std::uint64_t seed = 0; seed < studies; ++seed) {
    const auto sizes = fit_detection_sizes(drawn(60, 100 + seed));
    held += !sizes || !sizes->a90_95_mm || *sizes->a90_95_mm >= true_a90_mm ? 1 : 0;
  }
  EXPECT_GE(held, 179);
  EXPECT_LE(held, 199);
}

TEST(DetectionSizes, OfOneSizeAloneThereIsNoCurve) {
  EXPECT_FALSE(fit_detection_sizes(std::vector<DetectionTrial>(29, {10.0, true})));
  EXPECT_FALSE(fit_detection_sizes(std::vector<DetectionTrial>(29, {10.0, false})));
  EXPECT_FALSE(fit_detection_sizes({}));
}

TEST(DetectionSizes, FewTrialsProveNothing) {
  const std::vector<DetectionTrial> trials{
      {6.0, false}, {8.0, true}, {9.0, false}, {10.0, true}, {12.0, true}};
  const auto sizes = fit_detection_sizes(trials);
  ASSERT_TRUE(sizes);
  EXPECT_FALSE(sizes->a90_95_mm);
}

}  // namespace
}  // namespace rva
