// Findings on pictures.
#pragma once

#include <cstddef>
#include <optional>

#include "depth/capture.hpp"
#include "depth/image.hpp"
#include "detect/findings.hpp"

namespace rva {

/// The box of a finding as the colour imager sees it: each of its pixels goes through its depth, the
/// transform between the imagers and the colour intrinsics. Where the capture does not state both, the box is
/// scaled from one image to the other, as the thesis does.
/// @param final_m depth after, metres; 0 where not measured
/// @return empty where the finding lies outside the colour image
[[nodiscard]] std::optional<Box> box_on_color(const Finding& finding, const Image<float>& final_m,
                                              const CaptureInfo& capture, const ColorImage& color);

struct Overlay {
  ColorImage picture;
  std::size_t outside = 0;  ///< findings that lie outside this picture
};

/// Green boxes, numbered by the findings' ids, on the colour image (thesis figure 3.7).
[[nodiscard]] Overlay draw_on_color(ColorImage color, const std::vector<Finding>& findings,
                                    const Image<float>& final_m, const CaptureInfo& capture);

/// White boxes on the colourised depth, which needs no light (thesis figure 3.13). Pixel for pixel the depth
/// image; black where nothing was measured, blue near, red far.
/// @param left_out dimmed and hatched; empty for nothing
[[nodiscard]] ColorImage draw_on_depth(const Image<float>& final_m, const std::vector<Finding>& findings,
                                       const Mask& left_out = {});

/// Every changed pixel green on the colour image turned grey (thesis figure 3.19), at the pixel nearest to
/// its point; scaled from one image to the other where the capture does not tell how the imagers stand.
/// @param changed, final_m one size
[[nodiscard]] ColorImage draw_changed_points(ColorImage color, const Mask& changed,
                                             const Image<float>& final_m, const CaptureInfo& capture);

}  // namespace rva
