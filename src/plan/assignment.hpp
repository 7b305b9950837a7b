// Optimal assignment of the rows of a table to its columns.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rva {

/// Assigns each row to a column of its own so that the sum of the costs is least (Kuhn 1955, in the form with
/// shortest augmenting paths): in rows squared times columns steps.
/// @param costs finite; at least as many columns as rows
/// @return for each row its column
[[nodiscard]] std::vector<int> least_cost_assignment(const Eigen::MatrixXd& costs);

}  // namespace rva
