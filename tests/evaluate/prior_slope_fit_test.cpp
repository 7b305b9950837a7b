#include "evaluate/prior_slope_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"

namespace rva {
namespace {

// A gamma distributed number: with a whole shape, it is a sum of that many exponential ones.
double gamma(Random& random, int shape, double mean) {
  double sum = 0.0;
  for (int k = 0; k < shape; ++k) sum -= std::log(1.0 - random.uniform());
  return mean * sum / shape;
}

std::vector<std::vector<float>> drawn(std::size_t images, std::size_t peaks_each, double slope, int peaks,
                                      std::uint64_t seed) {
  Random random(seed);
  std::vector<std::vector<float>> drawn(images);
  for (std::vector<float>& of_image : drawn) {
    const double of_this = gamma(random, peaks, slope);
    while (of_image.size() < peaks_each)
      of_image.push_back(
          static_cast<float>(FalseAlarmTail::onset - std::log(1.0 - random.uniform()) / of_this));
  }
  return drawn;
}

TEST(PriorSlope, OfManyImagesIsTheirs) {
  const PriorSlopeFit fit = fit_prior_slope(drawn(1000, 20, 1.5, 8, 1));
  EXPECT_NEAR(fit.most_probable.slope, 1.5, 0.05);
  EXPECT_NEAR(fit.most_probable.peaks, 8.0, 1.0);
  EXPECT_EQ(fit.images, 1000U);
  EXPECT_EQ(fit.seen, 20000U);
}

// 95 of 100 hold the truth: 85 and more in all but 1 of 10,000 such tests.
TEST(PriorSlope, IntervalsIncludeTheTruthNineteenTimesOfTwenty) {
  int slopes = 0;
  int weights = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const PriorSlopeFit fit = fit_prior_slope(drawn(40, 15, 1.2, 10, 100 + seed));
    slopes += fit.slope.low <= 1.2 && 1.2 <= fit.slope.high ? 1 : 0;
    weights += fit.peaks.low <= 10.0 && 10.0 <= fit.peaks.high ? 1 : 0;
  }
  EXPECT_GE(slopes, 85);
  EXPECT_GE(weights, 85);
}

TEST(PriorSlope, ThatAllImagesShareHasTheMostPeaks) {
  const PriorSlopeFit fit = fit_prior_slope(drawn(400, 30, 2.0, 100000, 3));
  EXPECT_GT(fit.most_probable.peaks, 0.5 * most_prior_peaks);
  EXPECT_DOUBLE_EQ(fit.peaks.high, most_prior_peaks);
}

TEST(PriorSlope, NeedsAPeak) {
  EXPECT_THROW(static_cast<void>(fit_prior_slope({})), UsageError);
  EXPECT_THROW(static_cast<void>(fit_prior_slope({{}, {2.5F, 3.0F}})), UsageError);
}

}  // namespace
}  // namespace rva
