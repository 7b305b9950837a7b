// Evidence pooled over windows of one size, and the thresholds above which it is significant.
#pragma once

#include <vector>

#include "detect/calibrated/false_alarm_tail.hpp"
#include "detect/calibrated/pooled_evidence.hpp"
#include "detect/calibrated/unreliable_pixels.hpp"

namespace rva {

/// A window over which evidence is pooled, with the false alarms expected of it.
struct Scale {
  PooledEvidence evidence;
  ByReliability<FalseAlarmTail> tails;  ///< expected number of peaks, for either sign
  ByReliability<double> thresholds;     ///< in deviations of the pooled evidence
};

/// Heights of the peaks above the onset of a tail, of both signs. A peak is a pixel whose evidence no other
/// of its sign within a distance of one window exceeds.
[[nodiscard]] ByReliability<std::vector<float>> peaks_of(const PooledEvidence& evidence,
                                                         const Mask& unreliable);

/// Learns the tails of the peaks of unchanged pixels from the image itself, and sets thresholds by them.
/// @param unreliable         as returned by unreliable_pixels()
/// @param prior_slopes   prior slopes of the tails, for images with few peaks to learn from
/// @param false_findings expected number of peaks beyond the threshold in an unchanged image, for each sign
///                       at reliable and at unreliable pixels
[[nodiscard]] Scale scale_of(PooledEvidence evidence, const Mask& unreliable,
                             const ByReliability<PriorSlope>& prior_slopes, double false_findings);

}  // namespace rva
