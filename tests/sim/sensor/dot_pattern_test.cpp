#include "sim/sensor/dot_pattern.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rva {
namespace {

constexpr double pitch = 0.001;  // finer than a dot

/// The whole field, sampled from its upper left corner on.
Image<float> sampled(const DotPattern& pattern) {
  Image<float> field(static_cast<int>(2 * DotPattern::half_width / pitch),
                     static_cast<int>(2 * DotPattern::half_height / pitch));
  for (int v = 0; v < field.height(); ++v) {
    for (int u = 0; u < field.width(); ++u)
      field(u, v) = pattern.at(static_cast<float>(u * pitch - DotPattern::half_width),
                               static_cast<float>(v * pitch - DotPattern::half_height));
  }
  return field;
}

double mean_of(const Image<float>& field) {
  double sum = 0.0;
  for (const float value : field.pixels()) sum += static_cast<double>(value);
  return sum / static_cast<double>(field.size());
}

bool is_peak(const Image<float>& field, int u, int v) {
  for (int down = -1; down <= 1; ++down) {
    for (int right = -1; right <= 1; ++right) {
      if ((down != 0 || right != 0) && field(u + right, v + down) >= field(u, v)) return false;
    }
  }
  return true;
}

int count_peaks(const Image<float>& field) {
  int peaks = 0;
  for (int v = 1; v + 1 < field.height(); ++v) {
    for (int u = 1; u + 1 < field.width(); ++u) peaks += field(u, v) > 1.0F && is_peak(field, u, v) ? 1 : 0;
  }
  return peaks;
}

TEST(DotPattern, ItsMeanIsOne) {
  for (const int dots : {1000, 5000}) {
    for (const double share : {0.3, 1.0})
      EXPECT_NEAR(mean_of(sampled(DotPattern(dots, share, 1))), 1.0, 0.03) << dots << " " << share;
  }
}

TEST(DotPattern, HasAboutAsManyDotsAsAskedFor) {
  for (const int dots : {1000, 5000}) {
    for (const std::uint64_t seed : {1U, 2U})
      EXPECT_NEAR(count_peaks(sampled(DotPattern(dots, 0.8, seed))), dots, 0.05 * dots) << seed;
  }
}

TEST(DotPattern, BetweenDotsIsTheGlow) {
  const Image<float> field = sampled(DotPattern(2000, 0.8, 1));
  EXPECT_NEAR(*std::min_element(field.pixels().begin(), field.pixels().end()), 0.2F, 1e-6F);
  EXPECT_GT(*std::max_element(field.pixels().begin(), field.pixels().end()), 5.0F);
}

TEST(DotPattern, WithoutDotsTheFieldIsEven) {
  for (const DotPattern& pattern : {DotPattern(0, 0.8, 1), DotPattern(5000, 0.0, 1)}) {
    const Image<float> field = sampled(pattern);
    for (const float value : field.pixels()) ASSERT_NEAR(value, 1.0F, 1e-6F);
  }
}

TEST(DotPattern, OutsideOfTheFieldIsNothing) {
  const DotPattern pattern(5000, 0.5, 1);
  const auto right = static_cast<float>(DotPattern::half_width);
  const auto down = static_cast<float>(DotPattern::half_height);
  constexpr float beyond = 0.003F;
  for (float along = -0.5F; along < 0.5F; along += 0.0137F) {
    for (const float sign : {-1.0F, 1.0F}) {
      EXPECT_EQ(pattern.at(sign * (right + beyond), along), 0.0F);
      EXPECT_EQ(pattern.at(along, sign * (down + beyond)), 0.0F);
      EXPECT_GT(pattern.at(sign * (right - beyond), along), 0.0F);
      EXPECT_GT(pattern.at(along, sign * (down - beyond)), 0.0F);
    }
  }
}

TEST(DotPattern, DirectionsThatAreNoneAreOutside) {
  const DotPattern pattern(5000, 0.5, 1);
  for (const float value : {1e8F, 1e30F, std::numeric_limits<float>::infinity(), std::nanf("")}) {
    EXPECT_EQ(pattern.at(value, 0.0F), 0.0F);
    EXPECT_EQ(pattern.at(0.0F, -value), 0.0F);
    EXPECT_EQ(pattern.at(-value, value), 0.0F);
  }
}

TEST(DotPattern, SeedsAreCameras) {
  const Image<float> field = sampled(DotPattern(3000, 0.8, 5));
  EXPECT_EQ(field, sampled(DotPattern(3000, 0.8, 5)));
  EXPECT_NE(field, sampled(DotPattern(3000, 0.8, 6)));
}

TEST(DotPattern, IsSmooth) {
  const DotPattern pattern(5000, 0.8, 1);
  for (float x = -0.3F; x < 0.3F; x += 0.0001F)
    ASSERT_LT(std::abs(pattern.at(x + 0.0001F, 0.1F) - pattern.at(x, 0.1F)), 1.5F);
}

}  // namespace
}  // namespace rva
