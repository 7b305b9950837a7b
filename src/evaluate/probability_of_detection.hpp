// How large a thing has to be so that it is found: the curve that a quality engineer signs.
#pragma once

#include <optional>
#include <span>

namespace rva {

/// One thing that was there.
struct DetectionTrial {
  double size_mm = 0.0;  ///< above 0
  bool found = false;
};

/// The sizes at which a curve of hits and misses passes a half and nine tenths.
struct DetectionSizes {
  double a50_mm = 0.0;
  double a90_mm = 0.0;
  /// With a confidence of 95 %, things of this size and more are found nine times of ten. Empty where so few
  /// trials prove it for no size up to three times the largest one.
  std::optional<double> a90_95_mm;
};

/// Fits the probability of detection as a logistic function of the logarithm of size, which does not fall
/// with it, to hits and misses by penalised maximum likelihood (Firth 1993; MIL-HDBK-1823A, appendix G, has
/// it without the penalty); a90/95 is the one-sided bound by the ratio of likelihoods.
/// @return empty for things of one size alone, or where the likeliest curve passes a half or nine tenths
///         beyond a third of the smallest and three times the largest size
[[nodiscard]] std::optional<DetectionSizes> fit_detection_sizes(std::span<const DetectionTrial> trials);

}  // namespace rva
