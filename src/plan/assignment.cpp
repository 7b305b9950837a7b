#include "plan/assignment.hpp"

#include <cassert>
#include <cstddef>
#include <limits>

namespace rva {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int none = -1;

/// The assignment of the first rows, with the prices that prove that it is the least.
class Assignment {
 public:
  explicit Assignment(const Eigen::MatrixXd& costs)
      : costs_(costs),
        row_price_(Eigen::VectorXd::Zero(costs.rows())),
        column_price_(Eigen::VectorXd::Zero(costs.cols())),
        row_of_(static_cast<std::size_t>(costs.cols()), none) {}

  // Finds the cheapest path from the row, by way of rows that give up their column for another, to a column
  // that is free.
  void add(int row) {
    const auto columns = static_cast<int>(costs_.cols());
    Path path{Eigen::VectorXd::Constant(columns, infinite),
              std::vector<int>(static_cast<std::size_t>(columns), none),
              std::vector<bool>(static_cast<std::size_t>(columns), false)};
    int at = row;
    int last = none;
    double length = 0.0;
    while (at != none) {
      extend(path, at, last, length);
      last = nearest(path);
      length = path.length[last];
      path.done[static_cast<std::size_t>(last)] = true;
      at = row_of(last);
    }
    reprice(path, row, length);
    for (int column = last; column != none;) {
      const int before = path.before[static_cast<std::size_t>(column)];
      row_of_[static_cast<std::size_t>(column)] = before == none ? row : row_of(before);
      column = before;
    }
  }

  [[nodiscard]] std::vector<int> columns() const {
    std::vector<int> column_of(static_cast<std::size_t>(costs_.rows()), none);
    for (std::size_t column = 0; column < row_of_.size(); ++column) {
      if (row_of_[column] != none)
        column_of[static_cast<std::size_t>(row_of_[column])] = static_cast<int>(column);
    }
    return column_of;
  }

 private:
  struct Path {
    Eigen::VectorXd length;   // of the cheapest path to each column so far
    std::vector<int> before;  // the column before it on that path
    std::vector<bool> done;   // whether that path is the cheapest of all
  };

  [[nodiscard]] int row_of(int column) const { return row_of_[static_cast<std::size_t>(column)]; }

  void extend(Path& path, int row, int from, double length) const {
    for (int column = 0; column < costs_.cols(); ++column) {
      if (path.done[static_cast<std::size_t>(column)]) continue;
      const double reached = length + costs_(row, column) - row_price_[row] - column_price_[column];
      if (reached >= path.length[column]) continue;
      path.length[column] = reached;
      path.before[static_cast<std::size_t>(column)] = from;
    }
  }

  [[nodiscard]] static int nearest(const Path& path) {
    int best = none;
    for (int column = 0; column < path.length.size(); ++column) {
      if (!path.done[static_cast<std::size_t>(column)] &&
          (best == none || path.length[column] < path.length[best]))
        best = column;
    }
    return best;
  }

  // Keeps every price such that no cost is below the prices of its row and column together.
  void reprice(const Path& path, int row, double length) {
    row_price_[row] += length;
    for (int column = 0; column < costs_.cols(); ++column) {
      if (!path.done[static_cast<std::size_t>(column)]) continue;
      const double slack = length - path.length[column];
      column_price_[column] -= slack;
      if (row_of(column) != none) row_price_[row_of(column)] += slack;
    }
  }

  const Eigen::MatrixXd& costs_;
  Eigen::VectorXd row_price_;
  Eigen::VectorXd column_price_;
  std::vector<int> row_of_;
};

}  // namespace

std::vector<int> least_cost_assignment(const Eigen::MatrixXd& costs) {
  assert(costs.cols() >= costs.rows());
  Assignment assignment(costs);
  for (int row = 0; row < costs.rows(); ++row) assignment.add(row);
  return assignment.columns();
}

}  // namespace rva
