// How the tails of unchanged images usually fall off, from simulated ones.
#pragma once

#include <cstddef>
#include <vector>

#include "detect/calibrated/false_alarm_tail.hpp"
#include "evaluate/intervals.hpp"

namespace rva {

struct UsualSlopeFit {
  UsualSlope most_probable;
  Interval slope;          ///< per deviation
  Interval peaks;          ///< of UsualSlope
  std::size_t images = 0;  ///< with a peak
  std::size_t seen = 0;    ///< peaks in all of them
};

/// The weight of a slope that is the same in all images, as far as anyone can see.
inline constexpr double most_usual_peaks = 200.0;

/// Excesses over the onset of an image's tail are exponential with a slope of its own; slopes of images are
/// gamma distributed about the usual one, as narrowly as if each had been learnt from so many peaks. Then the
/// excesses of all images have a likelihood in closed form (empirical Bayes; Gelman et al., Bayesian Data
/// Analysis, section 5.1). Its maximum is the usual slope; intervals are those of the likelihood ratio.
/// @param peaks_of_images heights of peaks, in deviations, of images in which nothing changed; those below
///                        FalseAlarmTail::onset have no say
/// @throws UsageError without a peak
[[nodiscard]] UsualSlopeFit fit_usual_slope(const std::vector<std::vector<float>>& peaks_of_images);

}  // namespace rva
