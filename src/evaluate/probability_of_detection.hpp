// Probability of detection as a function of size, the measure used for qualification.
#pragma once

#include <optional>
#include <span>

namespace rva {

/// One object that was present.
struct DetectionTrial {
  double size_mm = 0.0;  ///< above 0
  bool found = false;    ///< whether it was found
};

/// The sizes at which the probability of detection reaches 50 % and 90 %.
struct DetectionSizes {
  double a50_mm = 0.0;  ///< probability of detection 50 %
  double a90_mm = 0.0;  ///< probability of detection 90 %
  /// With a confidence of 95 %, the probability of detection is at least 90 % from this size on. Empty if
  /// there are too few trials to show it for any size up to three times the largest.
  std::optional<double> a90_95_mm;
};

/// Fits the probability of detection to hits and misses, as a non-decreasing logistic function of the
/// logarithm of size, by penalised maximum likelihood (Firth 1993; MIL-HDBK-1823A, appendix G, describes it
/// without the penalty). a90/95 is a one-sided bound from the likelihood ratio.
/// @return empty if all sizes are equal, or if the most likely curve reaches 50 % or 90 % outside the range
///         from a third of the smallest to three times the largest size
[[nodiscard]] std::optional<DetectionSizes> fit_detection_sizes(std::span<const DetectionTrial> trials);

}  // namespace rva
