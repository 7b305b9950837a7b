// What infrared images show of change, and how often so much shows by chance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloud/judged_change.hpp"
#include "cloud/spatial_detection.hpp"

namespace rva {

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
