// How many locations of an unchanged image show a given amount of evidence by chance.
#pragma once

#include <vector>

namespace rva {

/// Expected number of peaks above a height. The number of peaks above `onset` falls off exponentially
/// (peaks over threshold, Pickands 1975), with a slope that is known from few peaks only. Averaged over a
/// gamma distribution of the slope with the given mean and shape `peaks`, the expected number at an excess
/// x is (1 + slope x / peaks)^-peaks times that at the onset, which is exponential for many peaks and
/// heavier for few.
class FalseAlarmTail {
 public:
  static constexpr double onset = 3.0;  ///< in deviations; a higher one would leave few peaks to learn from

  /// @param count  expected number of peaks above the onset
  /// @param slope  rate of the exponential decrease, per deviation
  /// @param peaks  number of peaks from which the slope was learnt
  FalseAlarmTail(double count, double slope, double peaks) : count_(count), slope_(slope), peaks_(peaks) {}

  /// Expected number of peaks above `height`; below `onset`, the number at it.
  [[nodiscard]] double expected_above(double height) const;
  /// log10 of expected_above(), exact where the number is too small for a double.
  [[nodiscard]] double log10_expected_above(double height) const;
  /// The height that `expected` peaks exceed on average, at least `onset`.
  [[nodiscard]] double height_of(double expected) const;

 private:
  double count_;
  double slope_;
  double peaks_;
};

/// Prior knowledge of the slope of a tail.
struct PriorSlope {
  double slope = 1.0;   ///< per deviation
  double peaks = 10.0;  ///< weight of the prior, as the number of peaks that it counts for
};

/// Fits the most probable tail of an image that is mostly unchanged. Only peaks between `onset` and `end` are
/// used, since most peaks of changes lie beyond.
/// @param peaks       heights of local maxima of evidence, in deviations, of both signs
/// @param end         in deviations, above `onset`
/// @return the tail of one sign, which has half of the peaks
[[nodiscard]] FalseAlarmTail fit_tail(const std::vector<float>& peaks, const PriorSlope& prior,
                                      double end = 7.0);

}  // namespace rva
