// Combines findings of depth with evidence from infrared images.
#pragma once

#include <vector>

#include "depth/image.hpp"
#include "detect/findings/detection.hpp"
#include "detect/findings/findings.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva {

/// Marks findings that a blob of changed appearance touches or comes within four pixels of, and removes such
/// blobs from the mask. Blobs farther away are objects of their own.
/// @param significant set where infrared images differ significantly
void give_evidence(Mask& significant, std::vector<Finding>& findings);

/// Sorts findings, the most suspicious first and those of appearance alone after all others, renumbers them
/// from 1, and updates their references to each other.
void order(std::vector<Finding>& findings);

/// How infrared images were compared: appearance between the dots only; also the surfaces that the stereo
/// pairs show; or every pixel, for a camera that stood still.
enum class InfraredCompared { appearance, surfaces, still };

/// True if a finding is from surfaces alone, without a difference in brightness, and is more than three times
/// as high as it is wide. Where a pattern repeats, the pairs of one side may match a few pixels of disparity
/// off, which resembles a spike. A real spike changes brightness, too.
[[nodiscard]] bool is_spike_of_surfaces(const Finding& finding, double focal_px);

/// The comparison of the infrared images of the same captures.
struct InfraredComparison {
  const Mask& judged;  ///< set where they were compared
  InfraredCompared compared;
  StereoScale stereo;
};

/// Drops findings without evidence in infrared images, if these were compared over most of the finding,
/// unless depth alone expects fewer such findings by chance than a fiftieth of those allowed, or, if surfaces
/// or every pixel were compared, a ten thousandth. For a camera that stood still, surfaces that moved by a
/// pixel of disparity or more, and depth that appeared or went missing, are always dropped without such
/// evidence: the dots on them would have moved, so the matcher merely decided differently on the same image.
/// Renumbers the others.
/// @param false_findings allowed for depth
void drop_unsupported(const InfraredComparison& infrared, double false_findings, Detection& detection);

}  // namespace rva
