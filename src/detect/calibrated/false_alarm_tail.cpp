#include "detect/calibrated/false_alarm_tail.hpp"

#include <algorithm>
#include <cmath>

#include "core/quantile.hpp"

namespace rva {
namespace {

constexpr double end = 2.0 * FalseAlarmTail::onset;
constexpr double usual_slope = 1.2;
constexpr double usual_peaks = 10.0;

// The slope of an exponential distribution that is cut off at `length`, by its median: 1 - exp(-slope median)
// is half of 1 - exp(-slope length). It falls from 2 ln 2 / length or more towards 0 as the median nears the
// middle.
double slope_of(double median, double length) {
  if (median >= 0.5 * length) return 0.0;
  double low = 0.0;
  double high = M_LN2 / median;
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double slope = 0.5 * (low + high);
    const bool too_steep = std::expm1(-slope * median) < 0.5 * std::expm1(-slope * length);
    (too_steep ? high : low) = slope;
  }
  return low;
}

}  // namespace

double FalseAlarmTail::log10_expected_above(double height) const {
  const double fallen = slope_ * (std::pow(std::max(height, onset), shape_) - std::pow(onset, shape_));
  return std::log10(places_) - fallen / M_LN10;
}

double FalseAlarmTail::expected_above(double height) const {
  return std::pow(10.0, log10_expected_above(height));
}

double FalseAlarmTail::height_of(double expected) const {
  const double fallen = std::max(0.0, std::log(places_ / expected));
  return std::pow(std::pow(onset, shape_) + fallen / slope_, 1.0 / shape_);
}

FalseAlarmTail fit_tail(const std::vector<float>& peaks, double shape) {
  const double origin = std::pow(FalseAlarmTail::onset, shape);
  const double length = std::pow(end, shape) - origin;
  std::vector<double> excesses;
  for (const float peak : peaks) {
    if (peak > FalseAlarmTail::onset && peak < end) excesses.push_back(std::pow(peak, shape) - origin);
  }
  const auto count = static_cast<double>(excesses.size());
  const double learnt = excesses.empty() ? 0.0 : slope_of(quantile(excesses, 0.5), length);
  const double slope = (count * learnt + usual_peaks * usual_slope) / (count + usual_peaks);
  const double beyond_too = count / -std::expm1(-slope * length);
  return {std::max(beyond_too, 1.0) / 2.0, slope, shape};
}

}  // namespace rva
