// Our images as OpenCV sees them: views, never copies.
#pragma once

#include <opencv2/core.hpp>

#include "depth/image.hpp"

namespace rva {

template <typename Pixel>
struct MatType;
template <>
struct MatType<std::uint8_t> {
  static constexpr int value = CV_8UC1;
};
template <>
struct MatType<std::uint16_t> {
  static constexpr int value = CV_16UC1;
};
template <>
struct MatType<float> {
  static constexpr int value = CV_32FC1;
};
/// Red first, where OpenCV's own files and colour maps have blue first.
template <>
struct MatType<Rgb> {
  static constexpr int value = CV_8UC3;
};

/// Shares the image's pixels; do not let it outlive the image.
template <typename Pixel>
cv::Mat as_mat(Image<Pixel>& image) {
  return {image.height(), image.width(), MatType<Pixel>::value, image.data()};
}

/// As above, to be read only: OpenCV has no matrix of constant pixels.
template <typename Pixel>
cv::Mat as_mat(const Image<Pixel>& image) {
  return {image.height(), image.width(), MatType<Pixel>::value, const_cast<Pixel*>(image.data())};
}

}  // namespace rva
