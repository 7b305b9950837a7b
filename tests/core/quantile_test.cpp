#include "core/quantile.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

TEST(Quantile, IsTheOrderStatistic) {
  std::vector<int> values{5, 1, 4, 2, 3};
  EXPECT_EQ(quantile(values, 0.0), 1);
  EXPECT_EQ(quantile(values, 0.5), 3);
  EXPECT_EQ(quantile(values, 0.74), 3);
  EXPECT_EQ(quantile(values, 1.0), 5);
}

TEST(Quantile, OfOneValueIsThatValue) {
  std::vector<float> values{7.0F};
  EXPECT_EQ(quantile(values, 0.3), 7.0F);
}

TEST(Quantile, TakesTheLowerOfTwo) {
  std::vector<int> values{2, 1};
  EXPECT_EQ(quantile(values, 0.5), 1);
}

}  // namespace
}  // namespace rva
