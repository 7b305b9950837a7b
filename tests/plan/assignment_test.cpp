#include "plan/assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/random.hpp"

namespace rva {
namespace {

double sum_of(const Eigen::MatrixXd& costs, const std::vector<int>& column_of) {
  double sum = 0.0;
  for (int row = 0; row < costs.rows(); ++row) sum += costs(row, column_of[static_cast<std::size_t>(row)]);
  return sum;
}

// The least sum over all assignments, one by one.
double least_sum(const Eigen::MatrixXd& costs) {
  std::vector<int> columns(static_cast<std::size_t>(costs.cols()));
  std::iota(columns.begin(), columns.end(), 0);
  double least = sum_of(costs, columns);
  while (std::ranges::next_permutation(columns).found) least = std::min(least, sum_of(costs, columns));
  return least;
}

Eigen::MatrixXd random_costs(int rows, int columns, Random& random) {
  Eigen::MatrixXd costs(rows, columns);
  for (double& cost : costs.reshaped()) cost = random.uniform(-5.0, 10.0);
  return costs;
}

TEST(LeastCostAssignment, IsAsCheapAsTheBestOfAllAssignments) {
  Random random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const int rows = 1 + trial % 5;
    const Eigen::MatrixXd costs = random_costs(rows, rows + trial % 3, random);
    EXPECT_NEAR(sum_of(costs, least_cost_assignment(costs)), least_sum(costs), 1e-9) << costs;
  }
}

TEST(LeastCostAssignment, GivesEachRowAColumnOfItsOwn) {
  Random random(8);
  std::vector<int> columns = least_cost_assignment(random_costs(40, 60, random));
  std::ranges::sort(columns);
  EXPECT_EQ(std::ranges::adjacent_find(columns), columns.end());
  EXPECT_GE(columns.front(), 0);
  EXPECT_LT(columns.back(), 60);
}

TEST(LeastCostAssignment, IsNotGreedy) {
  Eigen::MatrixXd costs(2, 2);
  costs << 1, 2, 2, 100;  // the cheapest pair alone forces the dearest one
  EXPECT_EQ(least_cost_assignment(costs), (std::vector{1, 0}));
}

TEST(LeastCostAssignment, OfNothingIsEmpty) {
  EXPECT_TRUE(least_cost_assignment(Eigen::MatrixXd(0, 3)).empty());
}

}  // namespace
}  // namespace rva
