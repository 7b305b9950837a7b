#include "detect/thesis/gaussian.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rva {
namespace {

DepthStatistics pixel(const std::vector<int>& depths) {
  DepthStatistics statistics(1, 1);
  for (const int depth : depths) statistics.add(DepthImage(1, 1, static_cast<std::uint16_t>(depth)));
  return statistics;
}

bool changed(const std::vector<int>& before, const std::vector<int>& after, double sigmas = 3.0) {
  return compare_gaussian(pixel(before), pixel(after), 0.001, {sigmas}).changed[0] == mask_set;
}

// Deviations of 1 on either side: the means must lie more than 3 + 3 apart (equations 3.1 and 3.2).
TEST(Gaussian, NeedsAGapOfThreeDeviationsOfEither) {
  EXPECT_FALSE(changed({999, 1001}, {993, 995}));
  EXPECT_TRUE(changed({999, 1001}, {992, 994}));
  EXPECT_TRUE(changed({999, 1001}, {993, 995}, 2.9));
  EXPECT_FALSE(changed({993, 995}, {999, 1001}));
}

TEST(Gaussian, AgreesWithNumpysDeviation) {
  // numpy.std of these is the population's: 2; the sample's would be 2.309 and give no detection.
  const std::vector<int> spread{998, 1002, 998, 1002};
  EXPECT_TRUE(changed(spread, {987, 987, 987, 987}, 6.0));
}

TEST(Gaussian, TieIsNoChange) {
  EXPECT_FALSE(changed({1000}, {1000}));
  EXPECT_TRUE(changed({1000}, {999}));
}

TEST(Gaussian, DropOutsDoNotCountAsDepth) {
  // As depth 0, one drop-out would give a deviation of hundreds and hide the change.
  EXPECT_TRUE(changed({1000, 1000, 0, 1000}, {900, 900, 900, 0}));
}

TEST(Gaussian, ComparesWhatHalfOfTheFramesSaw) {
  EXPECT_TRUE(changed({1000, 0}, {900, 0}));
  EXPECT_FALSE(changed({1000, 0, 0}, {900, 900, 900}));
  EXPECT_FALSE(changed({1000, 1000, 1000}, {900, 0, 0}));
  const Coverage unseen = compare_gaussian(pixel({1000, 0, 0}), pixel({900}), 0.001, {}).coverage;
  EXPECT_EQ(unseen.unseen, 1.0);
  const Coverage invalid = compare_gaussian(pixel({1000}), pixel({900, 0, 0}), 0.001, {}).coverage;
  EXPECT_EQ(invalid.invalid, 1.0);
}

}  // namespace
}  // namespace rva
