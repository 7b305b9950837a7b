#include "depth/depth_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "depth/depth_statistics_kernel.hpp"
#include "tests/depth/stacks.hpp"

namespace rva {
namespace {

using test::random_stack;

// The definition, pixel by pixel, in integers wide enough for anything.
void expect_exact(const DepthStatistics& statistics, const std::vector<DepthImage>& stack) {
  ASSERT_EQ(statistics.frames(), stack.size());
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    std::int64_t n = 0;
    std::int64_t s1 = 0;
    std::int64_t s2 = 0;
    for (const DepthImage& frame : stack) {
      const std::int64_t depth = frame[i];
      n += depth != 0 ? 1 : 0;
      s1 += depth;
      s2 += depth * depth;
    }
    ASSERT_EQ(statistics.count(i), n) << i;
    ASSERT_EQ(statistics.sum(i), s1) << i;
    ASSERT_EQ(statistics.scaled_variance(i), n * s2 - s1 * s1) << i;
    ASSERT_EQ(statistics.seen(i), n > 0 && 2 * n >= static_cast<std::int64_t>(stack.size())) << i;
    const double safe = n == 0 ? 1.0 : static_cast<double>(n);
    ASSERT_EQ(statistics.mean(i), static_cast<double>(s1) / safe) << i;
    ASSERT_EQ(statistics.standard_deviation(i), std::sqrt(static_cast<double>(n * s2 - s1 * s1)) / safe) << i;
  }
}

struct StackCase {
  int base;
  int spread;
  double holes;
};

// Quiet and wild pixels; depths at both ends of 16 bits; deviations that do and do not fit the fast path.
class EveryStack : public testing::TestWithParam<StackCase> {};

TEST_P(EveryStack, IsSummedExactly) {
  const auto [base, spread, holes] = GetParam();
  std::mt19937 random(static_cast<unsigned>(base + spread));
  for (const int frames : {1, 2, 3, 5, 7, 8, 9, 16, 23, 40}) {
    const int width = 1 + static_cast<int>(random() % 70);  // most widths leave pixels beside the registers
    const std::vector<DepthImage> stack = random_stack({width, 3, frames}, base, spread, holes, random);
    DepthStatistics statistics(width, 3);
    statistics.add(stack);
    expect_exact(statistics, stack);
  }
}

INSTANTIATE_TEST_SUITE_P(Depths, EveryStack,
                         testing::Values(StackCase{1000, 3, 0.0}, StackCase{1000, 3, 0.1},
                                         StackCase{1000, 30, 0.9}, StackCase{10000, 5000, 0.05},
                                         StackCase{30000, 23170, 0.0}, StackCase{30000, 23171, 0.0},
                                         StackCase{30000, 29999, 0.3}, StackCase{1, 40, 0.0},
                                         StackCase{65535, 40, 0.1}, StackCase{5, 0, 1.0}));

TEST(DepthStatistics, ExtremesDoNotOverflow) {
  // Deviations of 65534 in every frame but the first, as many as 16 bits of count allow in reason.
  std::vector<DepthImage> stack(600, DepthImage(33, 1, 65535));
  stack[0] = DepthImage(33, 1, 1);
  DepthStatistics statistics(33, 1);
  statistics.add(stack);
  expect_exact(statistics, stack);
}

TEST(DepthStatistics, GroupingDoesNotMatter) {
  std::mt19937 random(7);
  const std::vector<DepthImage> stack = random_stack({131, 67, 29}, 9000, 400, 0.1, random);
  DepthStatistics one_by_one(131, 67);
  for (const DepthImage& frame : stack) one_by_one.add(frame);
  expect_exact(one_by_one, stack);
  DepthStatistics in_groups(131, 67);
  const std::span<const DepthImage> frames(stack);
  in_groups.add(frames.first(11));
  in_groups.add(frames.subspan(11, 1));
  in_groups.add(frames.subspan(12));
  expect_exact(in_groups, stack);
}

TEST(DepthStatistics, ClearStartsAnew) {
  std::mt19937 random(8);
  const std::vector<DepthImage> stack = random_stack({20, 20, 12}, 900, 40, 0.2, random);
  DepthStatistics statistics(20, 20);
  statistics.add(std::span(stack).first(5));
  statistics.clear();
  statistics.add(std::span(stack).last(7));
  expect_exact(statistics, {stack.begin() + 5, stack.end()});
}

TEST(DepthStatistics, BothKernelsAgree) {
  if (!kernel::has_avx2()) GTEST_SKIP() << "this processor has no AVX2, so there is one kernel only";
  std::mt19937 random(9);
  for (std::size_t count = 1; count <= kernel::frames_per_pass; ++count) {
    const auto frames = static_cast<int>(count);
    for (const int spread : {0, 50, 23170, 32767}) {
      const std::vector<DepthImage> stack = random_stack({101, 1, frames}, 20000, spread, 0.1, random);
      std::vector<const std::uint16_t*> runs;
      for (const DepthImage& frame : stack) runs.push_back(frame.data());
      struct State {
        std::vector<std::uint16_t> reference = std::vector<std::uint16_t>(101);
        std::vector<std::uint16_t> count = std::vector<std::uint16_t>(101);
        std::vector<std::int32_t> sum = std::vector<std::int32_t>(101);
        std::vector<std::uint64_t> squares = std::vector<std::uint64_t>(101);
        kernel::Sums sums() { return {reference.data(), count.data(), sum.data(), squares.data()}; }
        bool operator==(const State&) const = default;
      };
      State portable;
      State vectorised;
      kernel::add_pass_portable(runs.data(), count, 101, portable.sums());
      kernel::add_pass_avx2(runs.data(), count, 101, vectorised.sums());
      EXPECT_EQ(portable, vectorised) << count << " frames, spread " << spread;
    }
  }
}

TEST(DepthStatistics, AFailedAddLeavesAllAsItWas) {
  DepthStatistics statistics(4, 4);
  const std::vector<DepthImage> good{DepthImage(4, 4, 10), DepthImage(4, 4, 20)};
  statistics.add(good);
  const std::vector<DepthImage> mixed{DepthImage(4, 4, 30), DepthImage(4, 3, 40)};
  EXPECT_THROW(statistics.add(mixed), Error);
  expect_exact(statistics, good);
}

TEST(DepthStatistics, RefusesMoreThanItCanHold) {
  DepthStatistics statistics(1, 1);
  const std::vector<DepthImage> many(DepthStatistics::max_frames, DepthImage(1, 1, 500));
  statistics.add(many);
  EXPECT_THROW(statistics.add(DepthImage(1, 1, 500)), Error);
  EXPECT_EQ(statistics.frames(), DepthStatistics::max_frames);
  EXPECT_EQ(statistics.mean(0), 500.0);
}

}  // namespace
}  // namespace rva
