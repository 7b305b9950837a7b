// Confidence intervals of counts.
#pragma once

#include <cstddef>
#include <string>

namespace rva {

/// A two-sided confidence interval of 95 %.
struct Interval {
  double low = 0.0;   ///< lower limit
  double high = 0.0;  ///< upper limit
};

/// The interval of a probability, given the number of successes in a number of trials (Clopper and Pearson
/// 1934). Its coverage is never less than 95 %. Without a trial, it is 0 to 1.
/// @param successes at most `trials`
[[nodiscard]] Interval share_interval(std::size_t successes, std::size_t trials);

/// The interval of a mean count per trial, given the total count, for counts of a Poisson distribution
/// (Garwood 1936).
/// @param trials at least 1
[[nodiscard]] Interval rate_interval(std::size_t count, std::size_t trials);

/// A cell of a table, "successes/trials share % (interval)"; "-" without a trial.
[[nodiscard]] std::string stated_share(std::size_t successes, std::size_t trials);

/// A cell of a table, "mean (interval)".
/// @param trials at least 1
[[nodiscard]] std::string stated_rate(std::size_t count, std::size_t trials);

}  // namespace rva
