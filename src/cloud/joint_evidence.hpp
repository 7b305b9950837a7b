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

/// True of a finding of surfaces alone, without a difference in brightness, that is more than three times as
/// high as it is wide: where a pattern repeats, the pairs of one side may match a few pixels of disparity
/// off, which looks like a spike. A spike that is there changes brightness, too.
[[nodiscard]] bool is_spike_of_surfaces(const Finding& finding, double focal_px);

/// How infrared images were compared with the same captures.
struct InfraredComparison {
  const Mask& judged;  ///< where they were compared
  InfraredCompared compared;
  double disparity_m_px;  ///< focal length times baseline
};

/// Drops findings without evidence in the infrared images where these were compared over most of the finding,
/// unless depth alone expects fewer such findings than a fiftieth of those allowed, and where surfaces or
/// every pixel were compared, a ten thousandth. Of a camera that stood still, surfaces that moved by a pixel
/// of disparity and more, and depth that came or went, are dropped in any case: the dots on them would be
/// elsewhere, and a matcher that decides otherwise about the same image is what is left. Numbers the others
/// anew.
/// @param false_findings allowed for depth
void drop_unsupported(const InfraredComparison& infrared, double false_findings, Detection& detection);

}  // namespace rva
