// Order statistics.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace rva {

/// The value that a share (0 to 1) of the values do not exceed, one of them, the lower where two would do.
/// Reorders the values; there must be one at least, and none NaN.
template <typename Value>
[[nodiscard]] Value quantile(std::vector<Value>& values, double share) {
  assert(!values.empty());
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// Deviation by the median of the sizes of what is scattered about 0, as a normal distribution would have it:
/// the larger half may be anything. As for quantile(), reorders the sizes, of which there must be one at
/// least.
template <typename Value>
[[nodiscard]] Value robust_deviation(std::vector<Value>& sizes) {
  constexpr double normal_per_median = 1.4826;
  return static_cast<Value>(normal_per_median) * quantile(sizes, 0.5);
}

}  // namespace rva
