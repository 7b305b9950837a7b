// Change that infrared images show, with how often so much shows by chance.
#pragma once

#include <vector>

#include "detect/calibrated/false_alarm_tail.hpp"
#include "infrared/appearance_change.hpp"
#include "stereo/surface_change.hpp"

namespace rva {

/// In the view of the first final capture.
struct JudgedChange {
  /// Deviations of all evidence of this light together: of appearance, 0 where its contrast is no more than
  /// what stains and reflections have, and of the surface.
  AppearanceChange change;
  FalseAlarmTail tail;  ///< of the peaks of these deviations, of either sign
  /// How far the surface moved, as the pairs of both imagers show it; empty where they were not compared.
  SurfaceChange surface{};
};

/// How fast peaks beyond three deviations get rarer in simulated inspections without change, with cameras
/// drawn by chance (docs/infrared.md), and up to where an inspection's own peaks are taken for unchanged:
/// things that hardly show have peaks beyond. Images under the lamp, which have no dots, count as those
/// between dots, and those of a camera that stood still as pairs; what their own tails measure
/// (docs/statistics.md) is not used yet.
struct UsualTail {
  UsualSlope slope;
  double end;
};
inline constexpr UsualTail tail_between_dots{.slope = {.slope = 2.0, .peaks = 40.0}, .end = 4.0};
inline constexpr UsualTail tail_with_pairs{.slope = {.slope = 1.6, .peaks = 20.0}, .end = 5.0};
inline constexpr UsualTail tail_of_still_pair = tail_with_pairs;
inline constexpr UsualTail tail_under_lamp = tail_between_dots;

/// Nothing where the contrast is no more than stains and reflections change by; a collar changes more.
void drop_faint(AppearanceChange& change);

/// Heights of the peaks, of both signs, of what is not beside a thing that changed beyond doubt.
[[nodiscard]] std::vector<float> peaks_of(const AppearanceChange& change);

/// Learns the tail from what is not beside a thing that changed beyond doubt.
[[nodiscard]] JudgedChange with_tail(AppearanceChange change, const UsualTail& usual,
                                     SurfaceChange surface = {});

}  // namespace rva
