// Statistics of repeated returns, with confidence intervals of 95 %.
#pragma once

#include <vector>

namespace rva {

/// A value with its two-sided confidence interval of 95 %.
struct Estimated {
  double value = 0.0;  ///< in the unit of the values
  double low = 0.0;    ///< lower limit
  double high = 0.0;   ///< upper limit
};

/// Values that scatter about means of their own, such as the returns to each pose.
using Groups = std::vector<std::vector<double>>;

/// The standard deviation of values about the mean of their group, which all groups share. Its interval is
/// that of normal values (chi-square), and too wide for values that are evenly distributed.
/// @param groups at least two values in one of them
[[nodiscard]] Estimated pooled_deviation(const Groups& groups);

/// By how much the values of one side are larger than those of another, in the mean of all groups, with
/// Student's interval.
/// @param smaller, larger as many groups, group by group of one pose; each has a value, one has two
[[nodiscard]] Estimated mean_difference(const Groups& smaller, const Groups& larger);

/// The largest absolute value; 0 without one.
[[nodiscard]] double largest(const Groups& groups);

}  // namespace rva
