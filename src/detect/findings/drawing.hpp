// Draws findings on colour and depth images.
#pragma once

#include <cstddef>
#include <optional>

#include "capture/capture.hpp"
#include "depth/image.hpp"
#include "detect/findings/findings.hpp"

namespace rva {

/// The box of a finding in the colour image. Each of its pixels is projected by its depth, the transform
/// between the imagers and the colour intrinsics. If the capture does not state both, the box is scaled from
/// one image to the other, as in the thesis.
/// @param final_m depth after, metres; 0 where not measured
/// @return empty if the finding lies outside the colour image
[[nodiscard]] std::optional<Box> box_on_color(const Finding& finding, const Image<float>& final_m,
                                              const CaptureInfo& capture, const ColorImage& color);

/// A picture with the findings drawn on it.
struct Overlay {
  ColorImage picture;
  std::size_t outside = 0;  ///< findings that lie outside this picture
};

/// Draws green boxes, numbered by the ids of the findings, on the colour image (thesis figure 3.7).
[[nodiscard]] Overlay draw_on_color(ColorImage color, const std::vector<Finding>& findings,
                                    const Image<float>& final_m, const CaptureInfo& capture);

/// Draws white boxes on the colourised depth image, which needs no ambient light (thesis figure 3.13). The
/// picture has the pixels of the depth image, and a legend at their right; black where nothing was measured,
/// blue near, red far.
/// @param left_out pixels to dim and hatch; empty for none
[[nodiscard]] ColorImage draw_on_depth(const Image<float>& final_m, const std::vector<Finding>& findings,
                                       const Mask& left_out = {});

/// Draws every changed pixel in green on the greyscale colour image (thesis figure 3.19), at the pixel
/// nearest to the projection of its point. If the capture does not state the transform between the imagers,
/// pixels are scaled from one image to the other.
/// @param changed, final_m changed pixels and depth after in metres, of one size
[[nodiscard]] ColorImage draw_changed_points(ColorImage color, const Mask& changed,
                                             const Image<float>& final_m, const CaptureInfo& capture);

}  // namespace rva
