// Images with gaps.
#pragma once

#include <opencv2/core.hpp>

#include "depth/image.hpp"

namespace rva {

/// Each gap gets the value of the nearest pixel that is none.
/// @param gaps 8 bits, of the image's size: not 0 at a gap
/// @return false, with the image as it was, when every pixel is a gap
bool fill_gaps(const cv::Mat& gaps, Image<float>& image);

}  // namespace rva
