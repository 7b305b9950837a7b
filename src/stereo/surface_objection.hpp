// Whether the pairs of each side object to the surface that the other side's depth shows.
#pragma once

#include <span>

#include "stereo/plane_sweep.hpp"

namespace rva {

/// In the reference's view.
struct SurfaceObjection {
  /// By how much worse the other side's surface explains a side's pairs than its own, of that side which
  /// objects less, in variances of the noise nearby; 0 where neither objects or not judged.
  Image<float> variances;
  Image<float> variances_nearby;  ///< the least of them within a pixel
  Mask judged;                    ///< set where at least a tenth of the pairs of either side see the pixel
};

/// A true change is objected to by both sides. Where one side's matcher was wrong, the other's surface
/// explains the pairs of that side as well.
/// @param surface_before, surface_after of the sides, both in the reference's view, to a pixel of disparity
/// @param before, after   pairs of the sides, at least one each
[[nodiscard]] SurfaceObjection surface_objection(const ReferenceSurface& surface_before,
                                                 const ReferenceSurface& surface_after, double disparity_m_px,
                                                 std::span<StereoView> before, std::span<StereoView> after);

}  // namespace rva
