// Fit of the prior slope of false alarm tails to unchanged simulated images.
#pragma once

#include <cstddef>
#include <vector>

#include "core/intervals.hpp"
#include "detect/calibrated/false_alarm_tail.hpp"

namespace rva {

/// The fit of the prior slope to unchanged images.
struct PriorSlopeFit {
  PriorSlope most_probable;  ///< maximum of the likelihood
  Interval slope;            ///< interval of PriorSlope::slope, per deviation
  Interval peaks;            ///< interval of PriorSlope::peaks
  std::size_t images = 0;    ///< images with a peak above the onset
  std::size_t seen = 0;      ///< peaks above the onset in all of them
};

/// The upper limit of the weight: beyond it, the slope is practically the same in all images.
inline constexpr double most_prior_peaks = 200.0;

/// Fits the prior slope and its weight. The model: excesses over the onset of an image's tail are exponential
/// with a slope per image; these slopes are gamma distributed around the prior slope, with the width of an
/// estimate from `peaks` peaks. The likelihood of the excesses of all images then has a closed form
/// (empirical Bayes; Gelman et al., Bayesian Data Analysis, section 5.1). Its maximum gives the prior slope;
/// intervals are likelihood ratio intervals.
/// @param peaks_of_images heights of peaks, in deviations, of images in which nothing changed; those below
///                        FalseAlarmTail::onset are ignored
/// @throws UsageError if no peak is above the onset
[[nodiscard]] PriorSlopeFit fit_prior_slope(const std::vector<std::vector<float>>& peaks_of_images);

}  // namespace rva
