// Change between infrared images of a camera that stood still.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "detect/spatial/judged_change.hpp"
#include "views/depth_view.hpp"

namespace rva {

/// Compares one capture a side, pixel by pixel including the dots. If the images of both imagers are
/// available, the motion of the surface is measured from the stereo pairs. It determines the kind of a
/// change, but no finding rests on it alone, since a single pair with small windows is matched wrongly
/// too often.
/// @param initial, final captures that have the left imager's image in this light
/// @param warnings       receives the reason if the images could not be compared
/// @return empty if they could not be compared
/// @throws Error when an image cannot be read
[[nodiscard]] std::optional<JudgedChange> still_change_between(const Capture& initial, const Capture& final,
                                                               const DepthView& final_view, Light light,
                                                               std::vector<std::string>& warnings);

}  // namespace rva
