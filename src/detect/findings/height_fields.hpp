// The heights of a finding as fields of JSON, in `detections.json` and in the API.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "detect/findings/findings.hpp"

namespace rva {

/// Adds those that are known: `height_mm`, `above_surroundings_mm` with `background_jump`,
/// `top_above_surroundings_mm` with `top_is_least` (docs/detection.md).
void add_heights(const Finding& finding, nlohmann::ordered_json& json);

}  // namespace rva
