// How long something takes, as counts by classes of duration.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rva {

/// Upper ends of the classes, seconds, rising; a last class has no end.
inline constexpr std::array<double, 12> duration_bounds_s{0.001, 0.0025, 0.005, 0.01, 0.025, 0.05,
                                                          0.1,   0.25,   0.5,   1.0,  2.5,   10.0};

/// Counts of durations.
struct DurationHistogram {
  std::array<std::uint64_t, duration_bounds_s.size() + 1> counts{};  ///< by class, each duration in one class
  double sum_s = 0.0;                                                ///< of all durations

  /// @param duration_s a class contains its upper end
  void add(double duration_s) {
    std::size_t i = 0;
    while (i < duration_bounds_s.size() && duration_s > duration_bounds_s.at(i)) ++i;
    ++counts.at(i);
    sum_s += duration_s;
  }
};

}  // namespace rva
