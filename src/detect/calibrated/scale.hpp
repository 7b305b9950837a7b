// Evidence pooled over windows of one size, and how much of it is more than chance.
#pragma once

#include <vector>

#include "detect/calibrated/false_alarm_tail.hpp"
#include "detect/calibrated/pooled_evidence.hpp"
#include "detect/calibrated/unsure_places.hpp"

namespace rva {

struct Scale {
  PooledEvidence evidence;
  ByPlace<FalseAlarmTail> tails;  ///< of the peaks of either sign
  ByPlace<double> thresholds;     ///< in deviations of the pooled evidence
};

/// Heights above the onset of a tail, of both signs. A peak is a place whose evidence no other of its sign
/// within a window exceeds.
[[nodiscard]] ByPlace<std::vector<float>> peaks_of(const PooledEvidence& evidence, const Mask& unsure);

/// Learns from the image itself how the peaks of unchanged places thin out.
/// @param unsure         as of unsure_places()
/// @param usual_slopes   of the tails, where there are few peaks to learn them from
/// @param false_findings peaks beyond the threshold, on average, of each sign in sure and in unsure places of
///                       an unchanged image
[[nodiscard]] Scale look_at(PooledEvidence evidence, const Mask& unsure,
                            const ByPlace<UsualSlope>& usual_slopes, double false_findings);

}  // namespace rva
