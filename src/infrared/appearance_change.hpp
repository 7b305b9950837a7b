// What looks different after the work, in the light of the projector between its dots.
#pragma once

#include "depth/image.hpp"
#include "infrared/dot_free_image.hpp"

namespace rva {

/// All images are in the reference's view.
struct AppearanceChange {
  /// Logarithm of the brightness after over that before, mean of a window of 5 x 5, as far as images half a
  /// pixel off do not explain it; above 0 for brighter. 0 where not judged.
  Image<float> contrast;
  Image<float> deviations;  ///< the same in deviations of its noise
  Mask judged;              ///< set where either side shows most of the window
};

/// Takes off what differs over wide windows (exposure, the level of ambient light), and weighs what is left
/// by how much the views of one side differ among themselves nearby.
/// @param lit pixels to judge (lit_in_all() of both sides)
[[nodiscard]] AppearanceChange appearance_change(const DotFreeImage& initial, const DotFreeImage& final,
                                                 const Mask& lit);

}  // namespace rva
