// Fills gaps in images.
#pragma once

#include <opencv2/core.hpp>

#include "depth/image.hpp"

namespace rva {

/// Fills each gap with the value of the nearest pixel that is not a gap.
/// @param gaps 8 bits, of the size of the image: not 0 at a gap
/// @return false, with the image unchanged, if every pixel is a gap
bool fill_gaps(const cv::Mat& gaps, Image<float>& image);

}  // namespace rva
