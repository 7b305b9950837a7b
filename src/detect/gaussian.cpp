#include "detect/gaussian.hpp"

#include <cassert>
#include <cmath>

namespace rva {
namespace {

// Variance of a value that is rounded to a whole number, both sets together.
constexpr double rounding_variance = 2.0 / 12.0;

}  // namespace

Comparison compare_gaussian(const DepthStatistics& initial, const DepthStatistics& final, double unit_m,
                            const GaussianOptions& options) {
  assert(initial.width() == final.width() && initial.height() == final.height());
  Comparison result(final.width(), final.height());
  std::size_t compared = 0;
  std::size_t unseen = 0;
  std::size_t blind = 0;
  for (std::size_t i = 0; i < final.size(); ++i) {
    const bool before = initial.seen(i);
    const bool after = final.seen(i);
    const double mean_i = initial.mean(i);
    const double mean_f = final.mean(i);
    if (before) result.initial_m[i] = static_cast<float>(mean_i * unit_m);
    if (after) result.final_m[i] = static_cast<float>(mean_f * unit_m);
    if (after && !before) ++unseen;
    if (!after || !before) continue;
    ++compared;
    const double std_i = initial.standard_deviation(i);
    const double std_f = final.standard_deviation(i);
    if (options.sigmas * (std_i + std_f) * unit_m > blind_from_m) ++blind;
    const double t_i = mean_i - options.sigmas * std_i;
    const double t_f = mean_f + options.sigmas * std_f;
    if (t_f < t_i) {
      result.changed[i] = mask_set;
      const double deviation = std::sqrt(std_i * std_i + std_f * std_f + rounding_variance);
      result.evidence[i] = static_cast<float>((mean_i - mean_f) / deviation);
    }
  }
  const auto share = [&](std::size_t pixels) {
    return static_cast<double>(pixels) / static_cast<double>(final.size());
  };
  result.coverage = {share(compared), share(unseen), share(final.size() - compared - unseen), std::nullopt};
  if (compared > 0) result.blind = static_cast<double>(blind) / static_cast<double>(compared);
  return result;
}

}  // namespace rva
