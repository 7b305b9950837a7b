#include "map/return_statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <numeric>

namespace rva {
namespace {

constexpr double tail = 0.025;

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Sum of the squares about the groups' means, and its degrees of freedom.
struct Scatter {
  double squares = 0.0;
  double freedom = 0.0;

  void add(const Groups& groups) {
    for (const std::vector<double>& values : groups) {
      if (values.empty()) continue;
      const double mean = mean_of(values);
      for (const double value : values) squares += (value - mean) * (value - mean);
      freedom += static_cast<double>(values.size()) - 1.0;
    }
  }
};

}  // namespace

// Equation 88 of docs/math.md.
Estimated pooled_deviation(const Groups& groups) {
  Scatter scatter;
  scatter.add(groups);
  assert(scatter.freedom > 0.0);
  const boost::math::chi_squared distribution(scatter.freedom);
  const auto deviation = [&](double per) { return std::sqrt(scatter.squares / per); };
  return {deviation(scatter.freedom), deviation(quantile(complement(distribution, tail))),
          deviation(quantile(distribution, tail))};
}

// Equation 89 of docs/math.md.
Estimated mean_difference(const Groups& smaller, const Groups& larger) {
  assert(smaller.size() == larger.size() && !smaller.empty());
  Scatter scatter;
  scatter.add(smaller);
  scatter.add(larger);
  assert(scatter.freedom > 0.0);
  double difference = 0.0;
  double per_variance = 0.0;
  for (std::size_t i = 0; i < smaller.size(); ++i) {
    difference += mean_of(larger[i]) - mean_of(smaller[i]);
    per_variance +=
        1.0 / static_cast<double>(smaller[i].size()) + 1.0 / static_cast<double>(larger[i].size());
  }
  const auto groups = static_cast<double>(smaller.size());
  difference /= groups;
  const double error = std::sqrt(scatter.squares / scatter.freedom * per_variance) / groups;
  const double half = error * quantile(complement(boost::math::students_t(scatter.freedom), tail));
  return {difference, difference - half, difference + half};
}

double largest(const Groups& groups) {
  double most = 0.0;
  for (const std::vector<double>& values : groups) {
    for (const double value : values) most = std::max(most, std::abs(value));
  }
  return most;
}

}  // namespace rva
