// Detects whether the surface moved, from the infrared pairs of both sides, without depth images.
#pragma once

#include <span>

#include "geometry/stereo_scale.hpp"
#include "stereo/plane_sweep.hpp"

namespace rva {

/// Edge of the square on which the evidence of a pixel is based: the windows of the costs and their mean.
inline constexpr int surface_window_px = 9;

/// Change of the surface in the reference view.
struct SurfaceChange {
  Image<float> nearer_px;   ///< disparity after minus that before; 0 where not judged
  Image<float> deviations;  ///< significance of the change, in deviations; positive where nearer
  /// Significance of a change of one pixel of disparity that fills the windows, extrapolated from small
  /// changes; 0 where not judged.
  Image<float> deviations_per_px;
  Mask judged;  ///< set where at least half of the pairs of each side see the pixel
};

/// Computes the generalised likelihood ratio of "one surface explains the pairs of both sides" against "each
/// side has its own surface": the least cost of both together minus the least of each. In depth images, edges
/// depend on which dots fall near them; costs at the same points of a surface do not.
/// @param start          surface in the reference view, to a few pixels of disparity
/// @param before, after  pairs of the sides, at least one each, with poses accurate to a tenth of a pixel
[[nodiscard]] SurfaceChange surface_change(const ReferenceSurface& start, const StereoScale& stereo,
                                           std::span<StereoView> before, std::span<StereoView> after);

}  // namespace rva
