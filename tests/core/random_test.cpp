#include "core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rva {
namespace {

constexpr int many = 200000;

/// Five standard errors, so that a right generator passes with any seed that a person may put here.
double five_errors(double deviation, int count = many) { return 5.0 * deviation / std::sqrt(count); }

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
};

Moments moments_of(const std::vector<double>& values) {
  Moments moments;
  for (const double value : values) moments.mean += value;
  moments.mean /= static_cast<double>(values.size());
  for (const double value : values) moments.variance += (value - moments.mean) * (value - moments.mean);
  moments.variance /= static_cast<double>(values.size());
  return moments;
}

std::vector<double> normals(std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values(many);
  for (double& value : values) value = random.normal();
  return values;
}

// What the generator's authors publish for these seeds.
TEST(Random, IsSplitmix) {
  Random zero(0);
  for (const std::uint64_t value : {0xE220A8397B1DCDAFULL, 0x6E789E6AA1B965F4ULL, 0x06C45D188009454FULL})
    EXPECT_EQ(zero.bits(), value);
  Random random(1234567);
  for (const std::uint64_t value : {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL,
                                    4593380528125082431ULL, 16408922859458223821ULL})
    EXPECT_EQ(random.bits(), value);
}

TEST(Random, UniformAndNormalOfASeedStayTheSame) {
  Random uniform(42);
  for (const double value : {0.74156487877182331, 0.1599103928769201, 0.27860113025513866})
    EXPECT_DOUBLE_EQ(uniform.uniform(), value);
  Random normal(42);
  for (const double value : {0.88224890622226881, -0.45084987571886009, 0.18835263411593151})
    EXPECT_NEAR(normal.normal(), value, 1e-12);
}

TEST(Random, UniformFillsItsRangeEvenly) {
  Random random(7);
  std::vector<double> values(many);
  std::array<int, 20> histogram{};
  for (double& value : values) {
    value = random.uniform(-3.0, 5.0);
    ASSERT_GE(value, -3.0);
    ASSERT_LT(value, 5.0);
    ++histogram[static_cast<std::size_t>((value + 3.0) / 8.0 * 20.0)];
  }
  const Moments moments = moments_of(values);
  EXPECT_NEAR(moments.mean, 1.0, five_errors(8.0 / std::sqrt(12.0)));
  EXPECT_NEAR(moments.variance, 64.0 / 12.0, five_errors(64.0 * std::sqrt(1.0 / 180.0)));
  for (const int count : histogram) EXPECT_NEAR(count, many / 20.0, 5.0 * std::sqrt(many / 20.0));
}

TEST(Random, NormalHasMeanZeroAndDeviationOne) {
  const Moments moments = moments_of(normals(8));
  EXPECT_NEAR(moments.mean, 0.0, five_errors(1.0));
  EXPECT_NEAR(moments.variance, 1.0, five_errors(std::sqrt(2.0)));
}

TEST(Random, NormalHasTheTailsOfABell) {
  const std::vector<double> values = normals(9);
  for (const double bound : {1.0, 2.0, 3.0}) {
    const auto within = std::count_if(values.begin(), values.end(),
                                      [bound](double value) { return std::abs(value) < bound; });
    const double share = std::erf(bound / std::sqrt(2.0));
    EXPECT_NEAR(static_cast<double>(within) / many, share, five_errors(std::sqrt(share * (1.0 - share))));
  }
}

TEST(Random, NeighboursAreIndependent) {
  for (const std::size_t lag : {1U, 2U, 3U}) {
    const std::vector<double> values = normals(10);
    double product = 0.0;
    for (std::size_t i = lag; i < values.size(); ++i) product += values[i] * values[i - lag];
    EXPECT_NEAR(product / many, 0.0, five_errors(1.0)) << lag;
  }
}

TEST(Mix, IsOneStepOfTheGeneratorForEachNumber) {
  static_assert(mix(0) == 0xE220A8397B1DCDAFULL);
  EXPECT_EQ(mix(5), Random(5).bits());
  EXPECT_EQ(mix(5, 9), Random(Random(5).bits() + 9).bits());
  EXPECT_EQ(mix(5, 9, 11), Random(mix(5, 9) + 11).bits());
}

TEST(Mix, OrderAndCountMatter) {
  EXPECT_NE(mix(1, 2), mix(2, 1));
  EXPECT_NE(mix(1), mix(1, 0));
  EXPECT_NE(mix(0, 1), mix(1));
  EXPECT_EQ(mix(-1), mix(~0ULL));
}

TEST(Mix, FewInputBitsChangeHalfOfTheOutput) {
  double changed = 0.0;
  for (std::uint64_t i = 0; i < 1000; ++i) changed += __builtin_popcountll(mix(3, i) ^ mix(3, i + 1));
  EXPECT_NEAR(changed / 1000.0, 32.0, five_errors(4.0, 1000));
}

}  // namespace
}  // namespace rva
