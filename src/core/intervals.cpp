#include "core/intervals.hpp"

#include <fmt/format.h>

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cassert>

namespace rva {
namespace {

constexpr double tail = 0.025;

}  // namespace

// Equation 70 of docs/math.md.
Interval share_interval(std::size_t successes, std::size_t trials) {
  assert(successes <= trials);
  const auto k = static_cast<double>(successes);
  const auto n = static_cast<double>(trials);
  Interval interval{0.0, 1.0};
  if (successes > 0) interval.low = boost::math::ibeta_inv(k, n - k + 1.0, tail);
  if (successes < trials) interval.high = boost::math::ibeta_inv(k + 1.0, n - k, 1.0 - tail);
  return interval;
}

// Equation 71 of docs/math.md.
Interval rate_interval(std::size_t count, std::size_t trials) {
  assert(trials > 0);
  const auto k = static_cast<double>(count);
  const auto n = static_cast<double>(trials);
  Interval interval;
  if (count > 0) interval.low = boost::math::gamma_p_inv(k, tail) / n;
  interval.high = boost::math::gamma_p_inv(k + 1.0, 1.0 - tail) / n;
  return interval;
}

std::string stated_share(std::size_t successes, std::size_t trials) {
  if (trials == 0) return "-";
  const Interval interval = share_interval(successes, trials);
  return fmt::format("{}/{} {:.0f} % ({:.0f}-{:.0f})", successes, trials,
                     100.0 * static_cast<double>(successes) / static_cast<double>(trials),
                     100.0 * interval.low, 100.0 * interval.high);
}

std::string stated_rate(std::size_t count, std::size_t trials) {
  const Interval interval = rate_interval(count, trials);
  return fmt::format("{:.3g} ({:.2g}-{:.2g})", static_cast<double>(count) / static_cast<double>(trials),
                     interval.low, interval.high);
}

}  // namespace rva
