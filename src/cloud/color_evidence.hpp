// What colour images show of change where there is light to see by.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloud/depth_view.hpp"
#include "cloud/judged_change.hpp"
#include "cloud/spatial_detection.hpp"

namespace rva {

/// True when all captures have colour images that can be laid upon depth, and there is light in those of the
/// first ones. A colour image that cannot be read counts as lit: comparing it warns.
[[nodiscard]] bool have_lit_color(const Captures& initial, const Captures& final);

/// Lays the colour images of both sides upon each other and compares red, green and blue light apart; the
/// channel that shows most counts. What moves while a capture is taken is not judged. Light that falls off
/// otherwise than before is taken off (level.hpp), but a shadow with a sharp edge is a change.
/// @param initial, final     two captures a side at least; have_lit_color()
/// @param initial_from_final as registered from depth
/// @param warnings           gets why images that have light could not be compared
/// @return empty where they were not; without a warning, where a capture is dark
/// @throws Interrupted
[[nodiscard]] std::optional<JudgedChange> color_change_between(const Captures& initial, const Captures& final,
                                                               const PlacedCaptures& placed,
                                                               const Transform& initial_from_final,
                                                               std::vector<std::string>& warnings);

/// The same of a camera that stood still between two captures: pixel upon pixel.
/// @param initial, final have_lit_color()
[[nodiscard]] std::optional<JudgedChange> still_color_change_between(const Capture& initial,
                                                                     const Capture& final,
                                                                     const DepthView& final_view,
                                                                     std::vector<std::string>& warnings);

}  // namespace rva
