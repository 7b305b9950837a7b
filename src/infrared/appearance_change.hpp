// Change of brightness between dot-free infrared images, in the light of the projector or a lamp.
#pragma once

#include "depth/image.hpp"
#include "infrared/dot_free_image.hpp"

namespace rva {

/// The change at each pixel of the reference view.
struct AppearanceChange {
  /// Logarithm of the ratio of brightness after to that before, averaged over a window of 5 x 5 pixels, as
  /// far as a misregistration of half a pixel does not explain it; positive for brighter. 0 where not judged.
  Image<float> contrast;
  Image<float> deviations;  ///< contrast in standard deviations of its noise
  Mask judged;              ///< set where both sides show most of the window
};

/// Removes differences over wide windows (exposure, the level of ambient light), and weights the remainder by
/// how much the views of one side differ from each other nearby.
/// @param lit pixels to judge (lit_in_all() of both sides)
[[nodiscard]] AppearanceChange appearance_change(const DotFreeImage& initial, const DotFreeImage& final,
                                                 const Mask& lit);

}  // namespace rva
