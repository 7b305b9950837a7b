// Images as OpenCV matrices that share their pixels.
#pragma once

#include <opencv2/core.hpp>

#include "depth/image.hpp"

namespace rva {

template <typename Pixel>
struct MatType;
/// OpenCV's type of one channel of this type.
template <>
struct MatType<std::uint8_t> {
  static constexpr int value = CV_8UC1;  ///< type of the matrix
};
/// OpenCV's type of one channel of this type.
template <>
struct MatType<std::uint16_t> {
  static constexpr int value = CV_16UC1;  ///< type of the matrix
};
/// OpenCV's type of one channel of this type.
template <>
struct MatType<float> {
  static constexpr int value = CV_32FC1;  ///< type of the matrix
};
/// The channels are RGB, whereas OpenCV's files and colour maps are BGR.
template <>
struct MatType<Rgb> {
  static constexpr int value = CV_8UC3;  ///< type of the matrix
};

/// The matrix shares the image's pixels and must not outlive it.
template <typename Pixel, typename Meaning>
cv::Mat as_mat(Image<Pixel, Meaning>& image) {
  return {image.height(), image.width(), MatType<Pixel>::value, image.data()};
}

/// The same for a constant image. The matrix must only be read: OpenCV has no type for constant pixels.
template <typename Pixel, typename Meaning>
cv::Mat as_mat(const Image<Pixel, Meaning>& image) {
  return {image.height(), image.width(), MatType<Pixel>::value, const_cast<Pixel*>(image.data())};
}

}  // namespace rva
