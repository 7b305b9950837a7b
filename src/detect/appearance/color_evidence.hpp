// Change between colour images, if they are lit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "detect/spatial/judged_change.hpp"
#include "detect/spatial/spatial_detection.hpp"
#include "views/depth_view.hpp"

namespace rva {

/// True if all captures have colour images that can be registered to depth, and those of the first captures
/// are lit. A colour image that cannot be read counts as lit, so that the comparison warns of it.
[[nodiscard]] bool have_lit_color(const Captures& initial, const Captures& final);

/// Registers the colour images of both sides and compares their red, green and blue channels; at each pixel,
/// the channel with the strongest change counts. Pixels that change during a capture are not judged. Smooth
/// changes of lighting are removed (level.hpp), but a shadow with a sharp edge counts as a change.
/// @param initial, final     at least two captures a side; have_lit_color()
/// @param initial_from_final as registered from depth
/// @param warnings           receives the reason if lit images could not be compared
/// @return empty if they were not compared; without a warning if a capture is dark
/// @throws Interrupted
[[nodiscard]] std::optional<JudgedChange> color_change_between(const Captures& initial, const Captures& final,
                                                               const PlacedCaptures& placed,
                                                               const Transform& initial_from_final,
                                                               std::vector<std::string>& warnings);

/// The same for a camera that stood still between two captures, pixel by pixel.
/// @param initial, final captures with have_lit_color()
[[nodiscard]] std::optional<JudgedChange> still_color_change_between(const Capture& initial,
                                                                     const Capture& final,
                                                                     const DepthView& final_view,
                                                                     std::vector<std::string>& warnings);

}  // namespace rva
