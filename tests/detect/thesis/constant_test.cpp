#include "detect/thesis/constant.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

// One pixel each: before, after.
Comparison compare(std::uint16_t before, std::uint16_t after, ConstantOptions options = {}) {
  return compare_constant(DepthImage(1, 1, before), DepthImage(1, 1, after), 0.001, options);
}

bool changed(std::uint16_t before, std::uint16_t after, ConstantOptions options = {}) {
  return compare(before, after, options).changed[0] == mask_set;
}

TEST(Constant, ChangedWhenNearerByMoreThanTheThreshold) {
  EXPECT_TRUE(changed(1051, 1000));
  EXPECT_FALSE(changed(1050, 1000));
  EXPECT_FALSE(changed(1000, 1051));
  EXPECT_TRUE(changed(1050, 1000, {.threshold_m = 0.04}));
}

TEST(Constant, ClipsTheFinalDepthOnly) {
  EXPECT_TRUE(changed(3000, 1999));
  EXPECT_FALSE(changed(3000, 2000));
  EXPECT_TRUE(changed(3000, 2000, {.clip_m = 2.5}));
}

TEST(Constant, NoMeasurementIsNoChange) {
  EXPECT_FALSE(changed(1000, no_depth));  // the thesis flags this one: 1000 - 0 is a large step
  EXPECT_FALSE(changed(no_depth, 1000));
  EXPECT_FALSE(changed(no_depth, no_depth));
}

TEST(Constant, CoverageIsAPartition) {
  EXPECT_EQ(compare(1000, 1000).coverage.compared, 1.0);
  EXPECT_EQ(compare(no_depth, 1000).coverage.unseen, 1.0);
  EXPECT_EQ(compare(1000, no_depth).coverage.invalid, 1.0);
  EXPECT_EQ(compare(1000, 2000).coverage.beyond_clip, 1.0);
  EXPECT_EQ(compare(no_depth, 2000).coverage.beyond_clip, 1.0);
}

TEST(Constant, GivesDepthInMetresAndEvidenceInThresholds) {
  const Comparison comparison = compare(1100, 1000);
  EXPECT_FLOAT_EQ(comparison.initial_m[0], 1.1F);
  EXPECT_FLOAT_EQ(comparison.final_m[0], 1.0F);
  EXPECT_FLOAT_EQ(comparison.evidence[0], 2.0F);
}

}  // namespace
}  // namespace rva
