// Change between infrared images that were taken from nearly one pose, dots included.
#pragma once

#include <vector>

#include "depth/image.hpp"
#include "infrared/dot_free_image.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {

/// All images are in the reference's view.
struct PairedChange {
  Image<float>
      deviations;  ///< by how many deviations of the unchanged image the surface is brighter than before
  Image<float> contrast;  ///< the same as a difference of logarithms; both 0 where not judged
  Mask judged;
};

/// A robot that returns brings each dither back to within half a servo step. The projector turns with the
/// camera, so a surface that did not change has the same dots at the same pixels, and each pair of images
/// differs by the surface's own texture alone, which moved by a pixel or two: that is taken off, as the
/// dot-free image shows it. What is left is divided by the noise of pixels as bright and as steep, and is
/// summed over 5 x 5 pixels. The median over the pairs counts, since an edge that moved shows in the pairs in
/// which it moved. Dots are ten times as bright as what lies between them, and show where a dot-free image
/// has nothing.
///
/// @param initial, final views of both sides on the surface, with poses to a tenth of a pixel; each final one
///                       is compared with the initial one of the nearest pose
/// @param texture        what the initial side's surface looks like
/// @param lit            pixels that may be judged
/// @return nothing judged where fewer than three pairs are from nearly one pose
[[nodiscard]] PairedChange paired_change(const ReferenceSurface& surface,
                                         const std::vector<InfraredView>& initial,
                                         const std::vector<InfraredView>& final, const DotFreeImage& texture,
                                         const Mask& lit);

/// The same for a camera that stood still: one pair, whose pixels see the same. Noise alone differs.
/// @param lit pixels that may be judged
[[nodiscard]] PairedChange still_change(const ReferenceSurface& surface, const InfraredView& initial,
                                        const InfraredView& final, const Mask& lit);

/// As far as the projector's light or other light reaches in both (beyond_projector()).
[[nodiscard]] PairedChange still_change(const ReferenceSurface& surface, const InfraredView& initial,
                                        const InfraredView& final);

}  // namespace rva
