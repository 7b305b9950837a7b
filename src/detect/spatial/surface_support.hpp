// Checks changes of depth against the infrared pairs from which depth was computed.
#pragma once

#include <cstddef>

#include "detect/regions/comparison.hpp"
#include "detect/spatial/spatial_detection.hpp"

namespace rva {

/// True if every capture of both sides has the images of both imagers under the projector.
[[nodiscard]] bool have_pairs(const Captures& initial, const Captures& final);

/// Factor by which a change to which the pairs of both sides object is rarer by chance than according to
/// depth alone, so that depth may propose that many times the allowed false findings: 20, but 1 if the camera
/// returned nearly and a side has fewer than four captures, since wrong matches of single pairs remain then.
/// @param captures number of captures of the side that has fewer
[[nodiscard]] double rarity_of_support(std::size_t captures, const Transform& initial_from_final);

/// Removes changes to which the pairs of one side do not object: the matcher of that side was wrong, and the
/// surface of the other side explains its images as well as its own (stereo/surface_objection.hpp). If the
/// camera did not return nearly and a side has fewer than four captures, thin lines are removed as well,
/// which an edge may leave if both matchers misplace it. The remaining changes become rarer by
/// rarity_of_support(). Images are never compared with those of the other side, so the camera may be at any
/// pose. Blobs where depth appeared or went missing remain if depth alone is significant.
/// @param initial, final captures with have_pairs()
/// @param false_findings allowed for depth alone
/// @param comparison     of depth in the final view, with rarity as evidence
/// @throws Error when an image cannot be read; Interrupted
void keep_supported(const Captures& initial, const Captures& final, const PlacedCaptures& placed,
                    const Transform& initial_from_final, double false_findings, Comparison& comparison);

}  // namespace rva
