// Order statistics.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace rva {

/// A normal distribution's deviation in units of the median of the deviations' sizes.
inline constexpr double normal_per_median = 1.4826;

/// The value that a share (0 to 1) of the values do not exceed, one of them, the lower where two would do.
/// Reorders the values; there must be one at least, and none NaN.
template <typename Value>
[[nodiscard]] Value quantile(std::vector<Value>& values, double share) {
  assert(!values.empty());
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace rva
