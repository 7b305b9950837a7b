// How many places of an unchanged image show so much evidence by chance.
#pragma once

#include <vector>

namespace rva {

/// Expected number of places above a height: rate of places above `onset`, which falls off as
/// exp(-slope (height^shape - onset^shape)) (peaks over threshold, Pickands 1975; a Weibull tail).
class FalseAlarmTail {
 public:
  static constexpr double onset = 3.0;  ///< in deviations; higher, few are left to learn from

  FalseAlarmTail(double places_above_onset, double slope, double shape)
      : places_(places_above_onset), slope_(slope), shape_(shape) {}

  /// From `onset` on; below it, the number at it.
  [[nodiscard]] double expected_above(double height) const;
  /// log10 of the same, exact where the number is too small for a double.
  [[nodiscard]] double log10_expected_above(double height) const;
  /// The height that so many places exceed, at least `onset`.
  [[nodiscard]] double height_of(double expected) const;

 private:
  double places_;
  double slope_;
  double shape_;
};

/// Fits to the peaks of an image most of which is unchanged. Only what lies between `onset` and twice that
/// has a say: the peaks of changes lie beyond, for the most part. The slope comes from the median there, so
/// that the rims of large changes count little; where few peaks are that high it leans on 1.2, a usual one,
/// as if that had been learnt from ten peaks.
/// @param peaks greatest evidence of each block of the image, in deviations, of both signs
/// @return of one sign: half of the peaks
[[nodiscard]] FalseAlarmTail fit_tail(const std::vector<float>& peaks, double shape);

}  // namespace rva
