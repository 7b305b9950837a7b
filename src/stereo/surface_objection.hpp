// Measures whether the pairs of each side object to the surface according to the depth of the other side.
#pragma once

#include <span>

#include "geometry/stereo_scale.hpp"
#include "stereo/plane_sweep.hpp"

namespace rva {

/// Objection of both sides in the reference view.
struct SurfaceObjection {
  /// By how much worse the surface of the other side explains the pairs of a side than its own, in
  /// variances of the noise nearby, for the side that objects less; 0 if either side does not object, or
  /// where not judged.
  Image<float> variances;
  Image<float> variances_nearby;  ///< least objection within a pixel
  Mask judged;                    ///< set where at least a tenth of the pairs of each side see the pixel
};

/// Computes the objection. Both sides object to a true change. If the matcher of one side was wrong, the
/// surface of the other side explains the pairs of that side as well.
/// @param surface_before, surface_after surfaces of the sides in the reference view, to a pixel of disparity
/// @param before, after   pairs of the sides, at least one each
[[nodiscard]] SurfaceObjection surface_objection(const ReferenceSurface& surface_before,
                                                 const ReferenceSurface& surface_after,
                                                 const StereoScale& stereo, std::span<StereoView> before,
                                                 std::span<StereoView> after);

}  // namespace rva
