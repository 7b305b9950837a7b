#include "detect/gaussian.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rva {
namespace {

// Variance of a value that is rounded to a whole number, both sets together.
constexpr double rounding_variance = 2.0 / 12.0;

// One set's depth of a pixel, in depth units.
struct Gaussian {
  double mean;
  double deviation;
};

// Equations 3.1 and 3.2.
bool is_nearer(const Gaussian& final, const Gaussian& initial, double sigmas) {
  const double t_i = initial.mean - sigmas * initial.deviation;
  const double t_f = final.mean + sigmas * final.deviation;
  return t_f < t_i;
}

double evidence(const Gaussian& final, const Gaussian& initial) {
  const double variance = initial.deviation * initial.deviation + final.deviation * final.deviation;
  return (initial.mean - final.mean) / std::sqrt(variance + rounding_variance);
}

}  // namespace

Comparison compare_gaussian(const DepthStatistics& initial, const DepthStatistics& final, double unit_m,
                            const GaussianOptions& options, const Mask& left_out) {
  assert(initial.width() == final.width() && initial.height() == final.height());
  Comparison result(final.width(), final.height());
  std::size_t compared = 0;
  std::size_t unseen = 0;
  std::size_t blind = 0;
  std::size_t omitted = 0;
  for (std::size_t i = 0; i < final.size(); ++i) {
    if (is_left_out(left_out, i)) ++omitted;
    const bool before = initial.seen(i);
    const bool after = final.seen(i);
    const Gaussian initial_i{initial.mean(i), initial.standard_deviation(i)};
    const Gaussian final_i{final.mean(i), final.standard_deviation(i)};
    if (before) result.initial_m[i] = static_cast<float>(initial_i.mean * unit_m);
    if (after) result.final_m[i] = static_cast<float>(final_i.mean * unit_m);
    if (is_left_out(left_out, i)) continue;
    if (after && !before) ++unseen;
    if (!after || !before) continue;
    ++compared;
    if (options.sigmas * (initial_i.deviation + final_i.deviation) * unit_m > blind_from_m) ++blind;
    if (is_nearer(final_i, initial_i, options.sigmas)) {
      result.changed[i] = mask_set;
      result.evidence[i] = static_cast<float>(evidence(final_i, initial_i));
    }
  }
  const auto share = [&](std::size_t pixels) {
    return static_cast<double>(pixels) / static_cast<double>(final.size());
  };
  result.coverage = {share(compared), share(unseen), share(final.size() - compared - unseen - omitted),
                     std::nullopt, left_out.empty() ? std::nullopt : std::optional(share(omitted))};
  result.blind = static_cast<double>(blind) / static_cast<double>(std::max<std::size_t>(compared, 1));
  return result;
}

}  // namespace rva
