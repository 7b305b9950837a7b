// Whether the surface moved, from the infrared pairs of both sides, without the depth images made of them.
#pragma once

#include <span>

#include "stereo/plane_sweep.hpp"

namespace rva {

/// Evidence of a pixel is of the square about it: the windows of costs, and their mean.
inline constexpr int surface_window_px = 9;

/// In the reference's view.
struct SurfaceChange {
  Image<float> nearer_px;  ///< disparity after, less that before; 0 where not judged
  Image<float>
      deviations;  ///< how certain it is that they differ, in deviations; above 0 where it came nearer
  /// Deviations that a change of one pixel of disparity has where it fills the windows, as small changes have
  /// them; 0 where not judged.
  Image<float> deviations_per_px;
  Mask judged;  ///< set where at least half of the pairs of either side see the pixel
};

/// The generalised likelihood ratio of "one surface explains the pairs of both sides" against "each side has
/// its own": the least cost of both together, less the least of each. What depth images tear at edges, other
/// dots tear elsewhere; costs of the same places do not depend on it.
/// @param start          of the reference, to a few pixels of disparity
/// @param before, after  pairs of the sides, at least one each; their poses to a tenth of a pixel
[[nodiscard]] SurfaceChange surface_change(const ReferenceSurface& start, double disparity_m_px,
                                           std::span<StereoView> before, std::span<StereoView> after);

}  // namespace rva
