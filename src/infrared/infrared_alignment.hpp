// Poses from the infrared images themselves: a hundredth of a degree where servos know a third of one.
#pragma once

#include <vector>

#include "infrared/dot_free_image.hpp"

namespace rva {

/// Refines where the views of one side were taken. The first one stays: it is the reference.
///
/// In turns, the views are fused and each is turned until it lies upon the result (Gauss and Newton, over
/// three rotations), pixels under dots left out, what differs in brightness over a wide window taken off,
/// outliers given Tukey's weights. Positions are taken as known: a turn of a sixth of a degree about the
/// robot's joints shifts the camera by 0.3 mm, which a turn of its own makes up for but for a tenth of a
/// pixel. With six degrees of freedom poses wandered along what a turn and a shift have in common, and twice
/// as much differed.
/// @param views at least one; their poses are known to half a degree
void align_side(const ReferenceSurface& surface, std::vector<InfraredView>& views);

/// The rounds that sides are aligned with (docs/infrared.md).
inline constexpr int usual_rounds = 8;

/// Refines where the views of another side were taken. What changed in between counts as outliers.
/// @param most_rounds above 0; ends before when no view turns by 0.002 degrees any more
void align_to(const DotFreeImage& image, const ReferenceSurface& surface, std::vector<InfraredView>& views,
              int most_rounds = usual_rounds);

}  // namespace rva
