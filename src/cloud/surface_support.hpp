// Changes of depth held against the infrared pairs that depth was made of.
#pragma once

#include <cstddef>

#include "cloud/spatial_detection.hpp"
#include "detect/comparison.hpp"

namespace rva {

/// Whether every capture of both sides has the images of both imagers under the projector.
[[nodiscard]] bool have_pairs(const Captures& initial, const Captures& final);

/// Changes that both sides' pairs object to are so many times rarer by chance than depth alone has it, so
/// that depth may propose so many times the false findings allowed: 20, but 1 where the camera came back
/// nearly with fewer than four captures of either side, since wrong matches of single pairs remain there.
/// @param captures of the side that has fewer
[[nodiscard]] double rarity_of_support(std::size_t captures, const Transform& initial_from_final);

/// Takes back changes that one side's pairs do not object to: there, its matcher was wrong, and the other
/// side's surface explains what it saw as well as its own (stereo/surface_objection.hpp); with fewer than
/// four captures of either side from elsewhere, also lines that an edge may leave which both matchers put
/// elsewhere. Those that stay are rarer by rarity_of_support(). No image is compared with one of the other
/// side, so that the camera may have come back to anywhere. Blobs whose depth went missing or came back stay
/// if depth alone shows them.
/// @param initial, final as of have_pairs()
/// @param false_findings allowed for depth alone
/// @param comparison     of depth in the final view, whose evidence is rarity
/// @throws Error when an image cannot be read; Interrupted
void keep_supported(const Captures& initial, const Captures& final, const PlacedCaptures& placed,
                    const Transform& initial_from_final, double false_findings, Comparison& comparison);

}  // namespace rva
