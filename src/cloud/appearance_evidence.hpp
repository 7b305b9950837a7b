// What infrared images show of change, and how often so much shows by chance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloud/spatial_detection.hpp"
#include "detect/calibrated/false_alarm_tail.hpp"
#include "infrared/appearance_change.hpp"

namespace rva {

struct JudgedChange {
  AppearanceChange change;  ///< in the view of the first final capture
  FalseAlarmTail tail;      ///< of its peaks, of either sign
};

/// Lays the images of both sides upon each other and compares them: those under the projector without its
/// dots, and where captures of both sides are from nearly one pose, pair by pair with them.
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
