// What infrared images of a camera that stood still show of change.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloud/depth_view.hpp"
#include "cloud/judged_change.hpp"
#include "depth/capture.hpp"

namespace rva {

/// Compares one capture a side, pixel upon pixel and dots included. Where both imagers' images are there, how
/// far the surface moved is measured from the pairs: it names what changed, but finds nothing by itself,
/// since one pair of small windows matches wrongly too often.
/// @param initial, final captures that have the left imager's image in this light
/// @param warnings       gets why images under the lamp could not be compared
/// @return empty where they could not
/// @throws Error when an image cannot be read
[[nodiscard]] std::optional<JudgedChange> still_change_between(const Capture& initial, const Capture& final,
                                                               const DepthView& final_view, Light light,
                                                               std::vector<std::string>& warnings);

}  // namespace rva
