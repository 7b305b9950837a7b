// What the pairs of both imagers could have shown of change: the level of detection of infrared evidence.
#pragma once

#include "cloud/appearance_evidence.hpp"
#include "detect/detection.hpp"

namespace rva {

/// Lowers the level of detection to what surfaces show (stereo/surface_change.hpp) wherever that is less than
/// what depth shows, and fills it in where depth was not judged. It is about things that are as wide as the
/// windows of both. Does nothing where surfaces were not compared, or depth has no level.
/// @param false_findings allowed for this light, of either sign
void lower_level_of_detection(const JudgedChange& light, double false_findings, double disparity_m_px,
                              Detection& detection);

}  // namespace rva
