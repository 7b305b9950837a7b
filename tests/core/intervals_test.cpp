#include "core/intervals.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

// Published values: Clopper and Pearson's for 0 and 3 of 10; Garwood's for 0, 1 and 10 events.
TEST(Intervals, OfASharePublished) {
  EXPECT_DOUBLE_EQ(share_interval(0, 10).low, 0.0);
  EXPECT_NEAR(share_interval(0, 10).high, 0.3085, 0.0001);
  EXPECT_NEAR(share_interval(3, 10).low, 0.0667, 0.0001);
  EXPECT_NEAR(share_interval(3, 10).high, 0.6525, 0.0001);
}

TEST(Intervals, OfARatePublished) {
  EXPECT_DOUBLE_EQ(rate_interval(0, 1).low, 0.0);
  EXPECT_NEAR(rate_interval(0, 1).high, 3.6889, 0.0001);
  EXPECT_NEAR(rate_interval(1, 1).low, 0.0253, 0.0001);
  EXPECT_NEAR(rate_interval(1, 1).high, 5.5716, 0.0001);
  EXPECT_NEAR(rate_interval(10, 10).low, 0.4795, 0.0001);
  EXPECT_NEAR(rate_interval(10, 10).high, 1.8390, 0.0001);
}

TEST(Intervals, SuccessesAndFailuresMirrorEachOther) {
  for (const std::size_t k : {0U, 1U, 7U, 19U, 20U}) {
    EXPECT_NEAR(share_interval(k, 20).low, 1.0 - share_interval(20 - k, 20).high, 1e-12);
  }
}

TEST(Intervals, WithoutATrialNothingIsKnown) {
  EXPECT_DOUBLE_EQ(share_interval(0, 0).low, 0.0);
  EXPECT_DOUBLE_EQ(share_interval(0, 0).high, 1.0);
}

}  // namespace
}  // namespace rva
