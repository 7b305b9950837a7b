// Findings of depth in the light of infrared images.
#pragma once

#include <vector>

#include "depth/image.hpp"
#include "detect/detection.hpp"
#include "detect/findings.hpp"

namespace rva {

/// Blobs that touch a finding, or come within four pixels of it, are evidence for it and leave the mask: what
/// stands farther beside it is a thing of its own.
/// @param significant where infrared images look different beyond chance
void give_evidence(Mask& significant, std::vector<Finding>& findings);

/// Drops findings without evidence in the infrared images where these were compared over most of the finding,
/// unless depth alone expects fewer such findings than a fiftieth of those allowed. Numbers the others anew.
/// @param judged         where infrared images were compared
/// @param false_findings allowed for depth
void drop_unsupported(const Mask& judged, double false_findings, Detection& detection);

}  // namespace rva
