// Change between infrared images of nearly one pose, including the dots.
#pragma once

#include <vector>

#include "depth/image.hpp"
#include "infrared/dot_free_image.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {

/// The change at each pixel of the reference view.
struct PairedChange {
  Image<float> deviations;  ///< increase of brightness in deviations of unchanged pixels; 0 if not judged
  Image<float> contrast;    ///< increase of brightness as a difference of logarithms; 0 if not judged
  Mask judged;              ///< set where images could be compared
};

/// Compares pairs of images of nearly one pose. A robot that returns brings each dithered pose back to within
/// half a servo step. The projector turns with the camera, so an unchanged surface has the same dots at the
/// same pixels, and each pair of images differs only by the texture of the surface, which moved by a pixel or
/// two; its effect is computed from the dot-free image and removed. The remainder is divided by the noise of
/// pixels of equal brightness and steepness and summed over 5 x 5 pixels. The median over the pairs is taken,
/// since an edge that moved shows only in the pairs in which it moved. Dots are ten times as bright as the
/// space between them, and show changes where a dot-free image has no samples.
///
/// @param initial, final views of both sides, with poses accurate to a tenth of a pixel; each final view is
///                       compared with the initial one of the nearest pose
/// @param texture        dot-free image of the initial side
/// @param lit            pixels that may be judged
/// @return nothing judged if fewer than three pairs are of nearly one pose
[[nodiscard]] PairedChange paired_change(const ReferenceSurface& surface,
                                         const std::vector<InfraredView>& initial,
                                         const std::vector<InfraredView>& final, const DotFreeImage& texture,
                                         const Mask& lit);

/// The same for a camera that stood still: one pair whose pixels see the same points and differ by
/// noise alone.
/// @param lit pixels that may be judged
[[nodiscard]] PairedChange still_change(const ReferenceSurface& surface, const InfraredView& initial,
                                        const InfraredView& final, const Mask& lit);

/// The same, judging the pixels that the light of the projector or other light reaches in both
/// images (beyond_projector()).
[[nodiscard]] PairedChange still_change(const ReferenceSurface& surface, const InfraredView& initial,
                                        const InfraredView& final);

}  // namespace rva
