// Alignment of depth images to the colour image.
#pragma once

#include "capture/capture.hpp"
#include "depth/image.hpp"

namespace rva {

/// Projects every depth pixel into the colour image, as the rectangle between its projected corners; where
/// several overlap, the nearest depth is kept. This is what librealsense's `align` does, and other programs
/// expect it.
/// @param info of the capture, with colour intrinsics and extrinsics
/// @return an image of the size of colour, in the same unit; 0 where no depth pixel projects to
/// @throws Error when the capture states no colour intrinsics or no extrinsics (color_from_depth)
[[nodiscard]] DepthImage align_to_color(const DepthImage& depth, const CaptureInfo& info);

}  // namespace rva
