#include "stereo/weighted_sums.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/random.hpp"

namespace rva {
namespace {

Image<std::int32_t> random_values(int width, int height, std::uint64_t seed) {
  Random random(seed);
  Image<std::int32_t> values(width, height);
  for (std::int32_t& value : values.pixels()) value = static_cast<std::int32_t>(random.uniform(-1000, 1000));
  return values;
}

WeightedSums sums_of(const Image<std::int32_t>& values, const WindowWeights& weights) {
  return {values.width(), values.height(), weights, [&](int u, int v) { return values(u, v); }};
}

/// How many steps a pixel of the window is inside its edge, 4 at most.
int slow_weight(int from_middle, int edge_px) { return std::min(4, edge_px / 2 + 1 - std::abs(from_middle)); }

int slow_sum(const Image<std::int32_t>& values, int edge_px, int u, int v) {
  int sum = 0;
  for (int down = -edge_px / 2; down <= edge_px / 2; ++down) {
    for (int right = -edge_px / 2; right <= edge_px / 2; ++right) {
      const int column = std::clamp(u + right, 0, values.width() - 1);
      const int row = std::clamp(v + down, 0, values.height() - 1);
      sum += slow_weight(right, edge_px) * slow_weight(down, edge_px) * values(column, row);
    }
  }
  return sum;
}

void expect_sums(const Image<std::int32_t>& values, int edge_px) {
  const WeightedSums sums = sums_of(values, WindowWeights(edge_px));
  for (int v = 0; v < values.height(); ++v) {
    for (int u = -WeightedSums::border_px; u < values.width() + WeightedSums::border_px; ++u)
      ASSERT_EQ(sums(u, v), slow_sum(values, edge_px, u, v)) << edge_px << ": " << u << " " << v;
  }
}

TEST(WeightedSums, AgreeWithTheDefinitionInsideAndBesideTheImage) {
  for (const int edge_px : {1, 3, 7, 9, 11}) expect_sums(random_values(47, 23, 1), edge_px);
}

TEST(WeightedSums, ImagesMayBeSmallerThanTheWindow) {
  for (const auto& [width, height] : {std::pair{1, 1}, {4, 1}, {1, 6}, {5, 5}})
    expect_sums(random_values(width, height, 2), 11);
}

TEST(WeightedSums, OfAConstantAreTheTotalWeight) {
  for (const int edge_px : {1, 5, 11}) {
    const WindowWeights weights(edge_px);
    const WeightedSums sums = sums_of(Image<std::int32_t>(30, 20, 1023), weights);
    for (const int u : {-24, 0, 15, 53}) EXPECT_EQ(sums(u, 10), 1023 * weights.total());
  }
}

TEST(WindowWeights, AreTheSameFromBothSides) {
  for (const int edge_px : {1, 3, 9, 11}) {
    const WindowWeights weights(edge_px);
    for (int i = 0; i < WindowWeights::lanes; ++i) {
      const int expected = i < edge_px ? slow_weight(i - edge_px / 2, edge_px) : 0;
      EXPECT_EQ(weights.along.at(static_cast<std::size_t>(i)), expected) << edge_px << ": " << i;
    }
  }
}

}  // namespace
}  // namespace rva
