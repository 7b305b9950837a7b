// Means around pixels, and the level that an image changed by.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// 1 where the mask is set, else 0.
[[nodiscard]] cv::Mat as_weights(const cv::Mat& mask);

/// The weighted mean of a square window around each pixel; 0 where it has no weight.
[[nodiscard]] cv::Mat window_mean(const cv::Mat& values, const cv::Mat& weights, int side_px);

/// Some of the values where the mask is set: enough for a median.
[[nodiscard]] std::vector<float> sampled(const cv::Mat& values, const Mask& mask);

/// The robust deviation of the values where the mask is set; 0 where it is set nowhere.
[[nodiscard]] float deviation_of(const cv::Mat& values, const Mask& mask);

/// What an image of differences of logarithms has in common: exposure, and light that falls off otherwise
/// than before. Its median, and the mean over 81 x 81 pixels of what lies near it. Things that changed do not
/// count, or the level beside them would lean towards them.
[[nodiscard]] cv::Mat level_of(const cv::Mat& difference, const Mask& judged);

}  // namespace rva
