// Depth as the colour camera would see it.
#pragma once

#include "depth/capture.hpp"
#include "depth/image.hpp"

namespace rva {

/// Every depth pixel, as the rectangle that its corners cover in the colour image; the nearest wins where
/// several do. As librealsense's `align` does it, which others' programs expect.
/// @param info of the capture, with colour and where it stands
/// @return of the size of colour, in the same unit; 0 where no depth pixel lies
/// @throws Error when the capture states no colour intrinsics or not where colour stands
[[nodiscard]] DepthImage align_to_color(const DepthImage& depth, const CaptureInfo& info);

}  // namespace rva
