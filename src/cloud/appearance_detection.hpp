// Findings from infrared images: what depth shows nothing of.
#pragma once

#include <string>
#include <vector>

#include "cloud/spatial_detection.hpp"

namespace rva {

/// The share of the false findings allowed that is left to depth where infrared images are compared, too.
inline constexpr double share_of_depth = 0.5;

/// The lights in which both sides have the infrared images that a comparison takes: under the projector, four
/// captures each, since fewer leave too many places under dots.
/// @param warnings gets why not, where some captures have them
[[nodiscard]] std::vector<Light> comparable_lights(const Captures& initial, const Captures& final,
                                                   std::vector<std::string>& warnings);

/// Compares the sides' infrared images in each light (appearance_evidence.hpp), where the camera came back
/// nearly to where it was. Findings of depth get the evidence of what looks different
/// there; those without are dropped where the images were compared and depth alone is not certain enough.
/// What looks different elsewhere becomes findings of kind `appearance`, after all others.
/// @param lights          as of comparable_lights()
/// @param false_findings  allowed for appearance alone, of all lights together
/// @throws Error when an image cannot be read; Interrupted
void add_appearance(const Captures& initial, const Captures& final, const std::vector<Light>& lights,
                    const PlacedCaptures& placed, double false_findings, const RegionOptions& regions,
                    Detection& detection);

/// The lights in which both captures have the left imager's image: one of each will do where the camera stood
/// still. None where the lens bends rays.
[[nodiscard]] std::vector<Light> still_lights(const Capture& initial, const Capture& final);

/// The same as add_appearance() for a camera that stood still between two captures: pixel by pixel, dots
/// included (still_evidence.hpp).
/// @param lights as of still_lights()
void add_still_appearance(const Capture& initial, const Capture& final, const std::vector<Light>& lights,
                          const DepthView& final_view, double false_findings, const RegionOptions& regions,
                          Detection& detection);

}  // namespace rva
