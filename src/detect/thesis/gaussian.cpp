#include "detect/thesis/gaussian.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace rva {
namespace {

// Variance due to rounding to whole depth units, of both sets together.
constexpr double rounding_variance = 2.0 / 12.0;

// Distribution of one pixel's depth in one set, in depth units.
struct Gaussian {
  double mean;
  double deviation;
};

// Equations 3.1 and 3.2.
// Equation 5 of docs/math.md.
bool is_nearer(const Gaussian& final, const Gaussian& initial, double sigmas) {
  const double t_i = initial.mean - sigmas * initial.deviation;
  const double t_f = final.mean + sigmas * final.deviation;
  return t_f < t_i;
}

// Equation 6 of docs/math.md.
double evidence(const Gaussian& final, const Gaussian& initial) {
  const double variance = initial.deviation * initial.deviation + final.deviation * final.deviation;
  return (initial.mean - final.mean) / std::sqrt(variance + rounding_variance);
}

enum class Pixel : std::uint8_t { compared, unseen, not_seen, left_out };
constexpr std::size_t kinds_of_pixels = 4;

Pixel kind_of(bool before, bool after, bool left_out) {
  if (left_out) return Pixel::left_out;
  if (!after) return Pixel::not_seen;
  return before ? Pixel::compared : Pixel::unseen;
}

Gaussian gaussian_of(const DepthStatistics& statistics, std::size_t i) {
  return {statistics.mean(i), statistics.standard_deviation(i)};
}

}  // namespace

Comparison compare_gaussian(const DepthStatistics& initial, const DepthStatistics& final, double unit_m,
                            const GaussianOptions& options, const Mask& left_out) {
  assert(initial.width() == final.width() && initial.height() == final.height());
  Comparison result(final.width(), final.height());
  std::array<std::size_t, kinds_of_pixels> counts{};
  std::size_t blind = 0;
  for (std::size_t i = 0; i < final.size(); ++i) {
    const Gaussian before = gaussian_of(initial, i);
    const Gaussian after = gaussian_of(final, i);
    if (initial.seen(i)) result.initial_m[i] = static_cast<float>(before.mean * unit_m);
    if (final.seen(i)) result.final_m[i] = static_cast<float>(after.mean * unit_m);
    const Pixel kind = kind_of(initial.seen(i), final.seen(i), is_left_out(left_out, i));
    ++counts.at(static_cast<std::size_t>(kind));
    if (kind != Pixel::compared) continue;
    if (options.sigmas * (before.deviation + after.deviation) * unit_m > blind_from_m) ++blind;
    if (!is_nearer(after, before, options.sigmas)) continue;
    result.changed[i] = mask_set;
    result.evidence[i] = static_cast<float>(evidence(after, before));
  }
  const auto count = [&](Pixel kind) { return counts.at(static_cast<std::size_t>(kind)); };
  const auto share = [&](Pixel kind) {
    return static_cast<double>(count(kind)) / static_cast<double>(final.size());
  };
  result.coverage = {.compared = share(Pixel::compared),
                     .unseen = share(Pixel::unseen),
                     .invalid = share(Pixel::not_seen),
                     .left_out = left_out.empty() ? std::nullopt : std::optional(share(Pixel::left_out))};
  result.blind =
      static_cast<double>(blind) / static_cast<double>(std::max<std::size_t>(count(Pixel::compared), 1));
  return result;
}

}  // namespace rva
