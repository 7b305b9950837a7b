// Findings from infrared images: what depth shows nothing of.
#pragma once

#include "cloud/spatial_detection.hpp"

namespace rva {

/// The share of the false findings allowed that is left to depth where infrared images are compared, too.
inline constexpr double share_of_depth = 0.5;

/// True where both sides have the infrared images that a comparison takes: four captures each, since fewer
/// leave too many places under dots.
/// @param warnings gets why not, where one side has them
[[nodiscard]] bool have_infrared(const Captures& initial, const Captures& final,
                                 std::vector<std::string>& warnings);

/// Compares the sides' infrared images without the projector's dots (infrared/appearance_change.hpp), where
/// the camera came back nearly to where it was. Findings of depth get the evidence of what looks different
/// there; those without are dropped where the images were compared and depth alone is not certain enough.
/// What looks different elsewhere becomes findings of kind `appearance`, after all others.
/// @param initial, final  as of have_infrared()
/// @param false_findings  allowed for appearance alone
/// @throws Error when an image cannot be read; Interrupted
void add_appearance(const Captures& initial, const Captures& final, const PlacedCaptures& placed,
                    double false_findings, const RegionOptions& regions, Detection& detection);

}  // namespace rva
