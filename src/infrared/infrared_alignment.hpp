// Poses from the infrared images themselves: a hundredth of a degree where servos know a third of one.
#pragma once

#include <vector>

#include "infrared/dot_free_image.hpp"

namespace rva {

/// Refines where the views of one side were taken. The first one stays: it is the reference.
///
/// In turns, the views are fused and each is laid upon the result (Gauss and Newton, over six degrees of
/// freedom), pixels under dots left out, what differs in brightness over a wide window taken off, outliers by
/// Tukey's weights. A pose may turn freely; how far the camera may have shifted is limited by what a turn
/// about the robot's joints makes of it.
/// @param views at least one; their poses are known to half a degree
void align_side(const ReferenceSurface& surface, std::vector<InfraredView>& views);

/// Refines where the views of another side were taken: what changed in between are outliers.
void align_to(const DotFreeImage& image, const ReferenceSurface& surface, std::vector<InfraredView>& views);

}  // namespace rva
