// Change in infrared or colour images, with the rate at which as much is found by chance.
#pragma once

#include <vector>

#include "detect/calibrated/false_alarm_tail.hpp"
#include "infrared/appearance_change.hpp"
#include "stereo/surface_change.hpp"

namespace rva {

/// All images are in the view of the first final capture.
struct JudgedChange {
  /// Combined evidence of this light, in deviations: of appearance, 0 where its contrast is no greater than
  /// that of stains and reflections, and of the surface.
  AppearanceChange change;
  FalseAlarmTail tail;  ///< expected number of peaks of these deviations, for either sign
  /// Motion of the surface according to the stereo pairs; empty if they were not compared.
  SurfaceChange surface{};
};

/// Prior slope of the tail of peaks beyond three deviations where nothing changed, as measured by
/// `script/fit` (docs/statistics.md), and the height up to which the peaks of an inspection are assumed to be
/// unchanged: objects of low contrast have peaks beyond.
struct TailPrior {
  PriorSlope slope;
  double end;
};
inline constexpr TailPrior tail_between_dots{.slope = {.slope = 1.53, .peaks = 19.72}, .end = 4.0};
inline constexpr TailPrior tail_with_pairs{.slope = {.slope = 1.63, .peaks = 22.62}, .end = 5.0};
inline constexpr TailPrior tail_of_still_pair{.slope = {.slope = 2.84, .peaks = 14.52}, .end = 5.0};
inline constexpr TailPrior tail_under_lamp{.slope = {.slope = 1.23, .peaks = 28.28}, .end = 4.0};

/// Contrast up to which stains and reflections change brightness between the dots or under a lamp; a collar
/// changes it by more.
inline constexpr float faint_contrast = 0.015F;

/// Sets the evidence to 0 where the contrast is at most `least`.
void drop_faint(AppearanceChange& change, float least = faint_contrast);

/// Heights of the peaks of both signs, except beside objects that have certainly changed.
[[nodiscard]] std::vector<float> peaks_of(const AppearanceChange& change);

/// Learns the tail from the pixels that are not beside an object that has certainly changed.
[[nodiscard]] JudgedChange with_tail(AppearanceChange change, const TailPrior& prior,
                                     SurfaceChange surface = {});

}  // namespace rva
