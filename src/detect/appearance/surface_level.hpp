// Level of detection of the stereo pairs.
#pragma once

#include "detect/appearance/appearance_evidence.hpp"
#include "detect/findings/detection.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva {

/// Lowers the level of detection to that of surfaces (stereo/surface_change.hpp) wherever it is below that of
/// depth, and fills it in where depth was not judged. It applies to objects as wide as the windows of both.
/// Does nothing if surfaces were not compared or depth has no level.
/// @param false_findings allowed for this light, for both signs together
void lower_level_of_detection(const JudgedChange& light, double false_findings, const StereoScale& stereo,
                              Detection& detection);

}  // namespace rva
