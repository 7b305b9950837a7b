#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace rva {
namespace {

class ParallelBands : public testing::TestWithParam<int> {};

TEST_P(ParallelBands, CoverEveryRowOnce) {
  const int rows = GetParam();
  std::vector<std::atomic<int>> visits(static_cast<std::size_t>(rows));
  parallel_bands(rows, [&](int first, int end) {
    for (int row = first; row < end; ++row) ++visits.at(static_cast<std::size_t>(row));
  });
  for (std::size_t row = 0; row < visits.size(); ++row) EXPECT_EQ(visits[row], 1) << row;
}

TEST_P(ParallelBands, AreNeverTurnedRound) {
  parallel_bands(GetParam(), [&](int first, int end) {
    EXPECT_LE(0, first);
    EXPECT_LE(first, end);
    EXPECT_LE(end, GetParam());
  });
}

INSTANTIATE_TEST_SUITE_P(Rows, ParallelBands, testing::Values(0, 1, 2, 3, 7, 64, 480, 1001));

TEST(Parallel, FailuresReachTheCaller) {
  const auto fail = [](int, int) { throw std::runtime_error("row 3 is bad"); };
  try {
    parallel_bands(100, fail);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "row 3 is bad");
  }
}

TEST(Parallel, OneBandsFailureLeavesTheOthersToEnd) {
  constexpr int rows = 1000;
  std::atomic<int> visited{0};
  std::atomic<int> failed{0};
  const auto work = [&](int first, int end) {
    if (first == 0) {
      failed = end;
      throw std::logic_error("first band");
    }
    for (int row = first; row < end; ++row) ++visited;
  };
  EXPECT_THROW(parallel_bands(rows, work), std::logic_error);
  EXPECT_EQ(visited + failed, rows);
}

TEST(Parallel, TheLastBandsFailureCountsToo) {
  constexpr int rows = 50;
  const auto work = [](int, int end) {
    if (end == rows) throw std::out_of_range("last band");
  };
  EXPECT_THROW(parallel_bands(rows, work), std::out_of_range);
}

TEST(Parallel, BandsMayHaveBandsOfTheirOwn) {
  std::atomic<int> visited{0};
  parallel_bands(8, [&](int first, int end) {
    for (int row = first; row < end; ++row)
      parallel_bands(16, [&](int from, int to) { visited += to - from; });
  });
  EXPECT_EQ(visited, 8 * 16);
}

}  // namespace
}  // namespace rva
