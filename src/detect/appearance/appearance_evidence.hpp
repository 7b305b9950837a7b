// Change between infrared images of both sides, and how often as much is found by chance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "detect/spatial/judged_change.hpp"
#include "detect/spatial/spatial_detection.hpp"

namespace rva {

/// Registers the infrared images of both sides and compares them. Under the projector, they are compared
/// without its dots; including the dots, in pairs of an initial and a final capture of nearly one pose; and
/// by the surfaces that explain the stereo pairs, if the images of both imagers are available.
/// @param initial, final     captures that have infrared images in this light
/// @param initial_from_final as registered from depth
/// @param warnings           receives the reason if the images could not be compared
/// @return empty if they could not be compared
/// @throws Error when an image cannot be read; Interrupted
[[nodiscard]] std::optional<JudgedChange> change_between(const Captures& initial, const Captures& final,
                                                         const PlacedCaptures& placed,
                                                         const Transform& initial_from_final, Light light,
                                                         std::vector<std::string>& warnings);

}  // namespace rva
