// How sure a counted figure is.
#pragma once

#include <cstddef>
#include <string>

namespace rva {

/// 95 %, two-sided.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Of a probability, `successes` of `trials` seen (Clopper and Pearson 1934): never less than 95 %. From 0 to
/// 1 without a trial.
[[nodiscard]] Interval share_interval(std::size_t successes, std::size_t trials);

/// Of a mean count per trial, `count` seen in all, if counts are scattered by chance (Garwood 1936). There
/// must be one trial at least.
[[nodiscard]] Interval rate_interval(std::size_t count, std::size_t trials);

/// "successes/trials share % (interval)", for a table; "-" without a trial.
[[nodiscard]] std::string stated_share(std::size_t successes, std::size_t trials);

/// "mean (interval)", for a table. There must be one trial at least.
[[nodiscard]] std::string stated_rate(std::size_t count, std::size_t trials);

}  // namespace rva
