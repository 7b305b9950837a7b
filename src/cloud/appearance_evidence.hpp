// What infrared images show of change, and how often so much shows by chance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloud/spatial_detection.hpp"
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

/// Lays the images of both sides upon each other and compares them: those under the projector without its
/// dots, where captures of both sides are from nearly one pose, pair by pair with them, and where both
/// imagers' images are there, by the surfaces that explain them.
/// @param initial, final     captures that have infrared images in this light
/// @param initial_from_final as registered from depth
/// @param warnings           gets why the images could not be compared
/// @return empty where they could not
/// @throws Error when an image cannot be read; Interrupted
[[nodiscard]] std::optional<JudgedChange> change_between(const Captures& initial, const Captures& final,
                                                         const PlacedCaptures& placed,
                                                         const Transform& initial_from_final, Light light,
                                                         std::vector<std::string>& warnings);

}  // namespace rva
