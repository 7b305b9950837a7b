// How many places of an unchanged image show so much evidence by chance.
#pragma once

#include <vector>

namespace rva {

/// Expected number of places above a height. Places above `onset` fall off exponentially (peaks over
/// threshold, Pickands 1975), with a slope that is known from few peaks only: averaged over what it may be
/// (a gamma distribution), places = N (1 + slope x / peaks)^-peaks for an excess x, which is exponential for
/// many peaks and heavier for few.
class FalseAlarmTail {
 public:
  static constexpr double onset = 3.0;  ///< in deviations; higher, few are left to learn from

  /// @param places above the onset
  /// @param slope  per deviation
  /// @param peaks  that the slope was learnt from
  FalseAlarmTail(double places, double slope, double peaks) : places_(places), slope_(slope), peaks_(peaks) {}

  /// From `onset` on; below it, the number at it.
  [[nodiscard]] double expected_above(double height) const;
  /// log10 of the same, exact where the number is too small for a double.
  [[nodiscard]] double log10_expected_above(double height) const;
  /// The height that so many places exceed, at least `onset`.
  [[nodiscard]] double height_of(double expected) const;

 private:
  double places_;
  double slope_;
  double peaks_;
};

/// What is known of a tail's slope beforehand.
struct UsualSlope {
  double slope = 1.0;   ///< per deviation
  double peaks = 10.0;  ///< it counts as much as a slope that was learnt from so many peaks
};

/// The most probable tail of an image most of which is unchanged. Only peaks between `onset` and `end` have a
/// say: those of changes lie beyond, for the most part.
/// @param peaks       places that no other nearby exceeds, in deviations, of both signs
/// @param end         in deviations, above `onset`
/// @return of one sign: half of the peaks
[[nodiscard]] FalseAlarmTail fit_tail(const std::vector<float>& peaks, const UsualSlope& usual,
                                      double end = 7.0);

}  // namespace rva
