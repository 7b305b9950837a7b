// Order statistics.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace rva {

/// The quantile of the values at `share` (0 to 1): one of the values, the lower one where it lies
/// between two.
/// @param values at least one, none of them NaN; they are reordered
template <typename Value>
[[nodiscard]] Value quantile(std::vector<Value>& values, double share) {
  assert(!values.empty());
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// Standard deviation of a quantity scattered about 0, estimated from the median of its absolute values on
/// the assumption of a normal distribution, so that nearly half of the values may be outliers.
/// @param sizes absolute values: at least one, none of them NaN; they are reordered
template <typename Value>
[[nodiscard]] Value robust_deviation(std::vector<Value>& sizes) {
  constexpr double normal_per_median = 1.4826;
  return static_cast<Value>(normal_per_median) * quantile(sizes, 0.5);
}

}  // namespace rva
