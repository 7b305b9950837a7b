// Window means and robust statistics of images, and the smooth change of brightness between two images.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// 1 where the mask is set, else 0.
[[nodiscard]] cv::Mat as_weights(const cv::Mat& mask);

/// The weighted mean of a square window around each pixel; 0 where it has no weight.
[[nodiscard]] cv::Mat window_mean(const cv::Mat& values, const cv::Mat& weights, int side_px);

/// A sample of the values where the mask is set, large enough for a median.
[[nodiscard]] std::vector<float> sampled(const cv::Mat& values, const Mask& mask);

/// The robust deviation of the values where the mask is set; 0 where it is set nowhere.
[[nodiscard]] float deviation_of(const cv::Mat& values, const Mask& mask);

/// Smooth part of an image of differences of logarithms: exposure, and light that falls off differently than
/// before. It is the median plus the mean, over 81 x 81 pixels, of values near the median. Changed objects
/// are excluded, so that they do not bias the level beside them.
[[nodiscard]] cv::Mat level_of(const cv::Mat& difference, const Mask& judged);

}  // namespace rva
