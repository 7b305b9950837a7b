#include "detect/calibrated/pooled_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace rva {
namespace {

Image<float> white(int width, int height, std::uint64_t seed) {
  Image<float> evidence(width, height);
  Random random(seed);
  for (float& pixel : evidence.pixels()) pixel = static_cast<float>(random.normal());
  return evidence;
}

double variance(const PooledEvidence& pooled) {
  double squares = 0.0;
  for (const float value : pooled.deviations.pixels()) squares += static_cast<double>(value) * value;
  return squares / static_cast<double>(pooled.deviations.size());
}

TEST(PooledEvidence, OfIndependentPixelsHasVarianceOne) {
  const PooledEvidence pooled = pool(white(400, 300, 1), Mask(400, 300, mask_set), 9);
  EXPECT_NEAR(variance(pooled), 1.0, 0.1);
  EXPECT_NEAR(pooled.spread, 1.0, 0.06);
}

TEST(PooledEvidence, OfNeighboursThatAgreeHasItToo) {
  Image<float> evidence = white(400, 300, 2);
  for (int v = 0; v < 300; ++v) {
    for (int u = 0; u < 400; ++u) evidence(u, v) = evidence(u - u % 4, v - v % 4);
  }
  const PooledEvidence pooled = pool(evidence, Mask(400, 300, mask_set), 9);
  EXPECT_NEAR(variance(pooled), 1.0, 0.15);
  EXPECT_NEAR(pooled.spread, 4.0, 0.6) << "16 pixels that agree count once";
}

TEST(PooledEvidence, IsOddInItsEvidence) {
  Image<float> evidence = white(100, 80, 3);
  const PooledEvidence pooled = pool(evidence, Mask(100, 80, mask_set), 15);
  for (float& pixel : evidence.pixels()) pixel = -pixel;
  const PooledEvidence turned = pool(evidence, Mask(100, 80, mask_set), 15);
  for (std::size_t i = 0; i < evidence.size(); ++i)
    EXPECT_FLOAT_EQ(pooled.deviations[i], -turned.deviations[i]);
}

TEST(PooledEvidence, NeedsHalfOfItsWindow) {
  Mask judged(100, 80, mask_set);
  for (int v = 0; v < 80; ++v) {
    for (int u = 0; u < 50; ++u) judged(u, v) = 0;
  }
  const PooledEvidence pooled = pool(white(100, 80, 4), judged, 9);
  EXPECT_EQ(pooled.pooled(49, 40), 0) << "not judged itself";
  EXPECT_EQ(pooled.pooled(50, 40), mask_set) << "five columns of nine";
  EXPECT_EQ(pooled.pooled(50, 0), 0) << "a quarter of the window";
  EXPECT_EQ(pooled.deviations(50, 0), 0.0F);
}

TEST(PooledEvidence, TakesASpreadThatIsKnown) {
  Image<float> evidence(100, 80);
  for (int v = 20; v < 29; ++v) {
    for (int u = 30; u < 39; ++u) evidence(u, v) = 1.0F;
  }
  const PooledEvidence pooled = pool(evidence, Mask(100, 80, mask_set), 9, 0.3);
  EXPECT_EQ(pooled.spread, 0.3);
  EXPECT_FLOAT_EQ(pooled.deviations(34, 24), 30.0F) << "81 / sqrt(81) / 0.3";
}

TEST(PooledEvidence, OfNothingIsNothing) {
  const PooledEvidence pooled = pool(Image<float>(20, 20), Mask(20, 20), 9);
  EXPECT_EQ(pooled.deviations, Image<float>(20, 20));
  EXPECT_EQ(pooled.pooled, Mask(20, 20));
}

}  // namespace
}  // namespace rva
