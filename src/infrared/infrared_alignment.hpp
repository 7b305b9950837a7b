// Refines poses by the infrared images, to a hundredth of a degree where servos report a third of one.
#pragma once

#include <vector>

#include "infrared/dot_free_image.hpp"

namespace rva {

/// Refines the poses of the views of one side. The first view is the reference and stays fixed.
///
/// Alternately, the views are fused, and each is rotated until it matches the result: Gauss-Newton over three
/// rotations, without pixels under dots, with differences of brightness over a wide window removed, and with
/// Tukey's weights for outliers. Positions are assumed to be known: a rotation by a sixth of a degree about
/// the joints of the robot shifts the camera by 0.3 mm, for which a further rotation compensates to within a
/// tenth of a pixel. With six degrees of freedom, poses drifted along combinations of rotation and
/// translation that are hard to distinguish, and twice as much differed between images.
/// @param views at least one; their poses are known to half a degree
void align_side(const ReferenceSurface& surface, std::vector<InfraredView>& views);

/// Rounds of alignment for the sides of a comparison (docs/infrared.md).
inline constexpr int usual_rounds = 8;

/// Refines the poses of the views of the other side against a fused image. Changes in between are treated
/// as outliers.
/// @param most_rounds above 0; ends earlier as soon as no view turns by 0.002 degrees or more
void align_to(const DotFreeImage& image, const ReferenceSurface& surface, std::vector<InfraredView>& views,
              int most_rounds = usual_rounds);

}  // namespace rva
