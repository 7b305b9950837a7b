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

/// How fast peaks beyond three deviations usually get rarer where nothing changed, as `script/fit` measures
/// it (docs/statistics.md), and up to where an inspection's own peaks are taken for unchanged: things that
/// hardly show have peaks beyond.
struct UsualTail {
  UsualSlope slope;
  double end;
};
inline constexpr UsualTail tail_between_dots{.slope = {.slope = 1.53, .peaks = 19.72}, .end = 4.0};
inline constexpr UsualTail tail_with_pairs{.slope = {.slope = 1.63, .peaks = 22.62}, .end = 5.0};
inline constexpr UsualTail tail_of_still_pair{.slope = {.slope = 2.84, .peaks = 14.52}, .end = 5.0};
inline constexpr UsualTail tail_under_lamp{.slope = {.slope = 1.23, .peaks = 28.28}, .end = 4.0};

/// By so much stains and reflections change brightness between the dots or under a lamp; a collar changes it
/// by more.
inline constexpr float faint_contrast = 0.015F;

/// Nothing where the contrast is no more than `least`.
void drop_faint(AppearanceChange& change, float least = faint_contrast);

/// Heights of the peaks, of both signs, of what is not beside a thing that changed beyond doubt.
[[nodiscard]] std::vector<float> peaks_of(const AppearanceChange& change);

/// Learns the tail from what is not beside a thing that changed beyond doubt.
[[nodiscard]] JudgedChange with_tail(AppearanceChange change, const UsualTail& usual,
                                     SurfaceChange surface = {});

}  // namespace rva
