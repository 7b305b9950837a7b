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

/// Puts the most suspicious first and those of appearance alone after all others, numbers them from 1, and
/// mends what they say of each other.
void order(std::vector<Finding>& findings);

/// What was compared of infrared images: how they look between the dots, or also the surfaces that the pairs
/// of both imagers show, or, of a camera that stood still, every pixel.
enum class InfraredCompared { appearance, surfaces, still };

/// Drops findings without evidence in the infrared images where these were compared over most of the finding,
/// unless depth alone expects fewer such findings than a fiftieth of those allowed, and where surfaces or
/// every pixel were compared, a ten thousandth. Numbers the others anew.
/// @param judged         where infrared images were compared
/// @param false_findings allowed for depth
void drop_unsupported(const Mask& judged, InfraredCompared compared, double false_findings,
                      Detection& detection);

}  // namespace rva
