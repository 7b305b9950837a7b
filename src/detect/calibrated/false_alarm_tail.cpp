#include "detect/calibrated/false_alarm_tail.hpp"

#include <algorithm>
#include <cmath>

namespace rva {
namespace {

// Returns the most probable slope s of n = `count` excesses x with the sum `sum` from an exponential
// distribution that is truncated at L = `length`, given a prior with the weight of k peaks of the slope s0.
// The logarithm of the posterior, n ln s - s sum(x) - n ln(1 - exp(-s L)) + k ln s - s k / s0, is maximal
// where its derivative by s is 0, which is found by bisection. Equation 21 of docs/math.md.
double most_probable_slope(double count, double sum, const PriorSlope& prior, double length) {
  const double prior_sum = prior.peaks / prior.slope;
  const auto rises_at = [&](double slope) {
    const double cut_off = count > 0.0 ? count * length / std::expm1(slope * length) : 0.0;
    return (count + prior.peaks) / slope > sum + prior_sum + cut_off;
  };
  double low = 0.0;
  double high = (count + prior.peaks) / (sum + prior_sum);
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double slope = 0.5 * (low + high);
    (rises_at(slope) ? low : high) = slope;
  }
  return high;
}

// The Fisher information that an excess contains about the slope if excesses are truncated at `length`, as a
// share of what it contains if they are not.
// Equation 24 of docs/math.md.
double information_share(double slope, double length) {
  const double cut_off = slope * length;
  const double growth = std::expm1(cut_off);
  return 1.0 - cut_off * cut_off * (growth + 1.0) / (growth * growth);
}

}  // namespace

// Equation 23 of docs/math.md.
double FalseAlarmTail::log10_expected_above(double height) const {
  const double excess = std::max(height, onset) - onset;
  return std::log10(count_) - peaks_ * std::log1p(slope_ * excess / peaks_) / M_LN10;
}

double FalseAlarmTail::expected_above(double height) const {
  return std::pow(10.0, log10_expected_above(height));
}

// Equation 26 of docs/math.md.
double FalseAlarmTail::height_of(double expected) const {
  const double fallen = std::max(0.0, std::log(count_ / expected));
  return onset + std::expm1(fallen / peaks_) * peaks_ / slope_;
}

// Equation 22 of docs/math.md.
FalseAlarmTail fit_tail(const std::vector<float>& peaks, const PriorSlope& prior, double end) {
  const double length = end - FalseAlarmTail::onset;
  double count = 0.0;
  double sum = 0.0;
  for (const float peak : peaks) {
    const double excess = static_cast<double>(peak) - FalseAlarmTail::onset;
    if (excess <= 0.0 || excess >= length) continue;
    count += 1.0;
    sum += excess;
  }
  const double slope = most_probable_slope(count, sum, prior, length);
  const double beyond_too = count / -std::expm1(-slope * length);
  const double known_peaks = count * information_share(slope, length) + prior.peaks;
  return {std::max(beyond_too, 1.0) / 2.0, slope, known_peaks};
}

}  // namespace rva
