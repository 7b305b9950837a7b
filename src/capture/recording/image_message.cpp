#include "capture/recording/image_message.hpp"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <opencv2/imgproc.hpp>
#include <string>

#include "capture/no_depth.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "depth/image_file.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

Error unsound(std::string_view source, const std::string& problem) {
  return {std::string(source), problem, "record it again"};
}

Error unknown_encoding(const ImageMessage& image, const char* kind, std::string_view source) {
  return unsound(source, fmt::format("a {} image has the encoding '{}', which is not supported", kind,
                                     printable(image.encoding)));
}

// Rows may be padded.
template <typename Copy>
Copy copy_rows(const ImageMessage& image, std::string_view source) {
  using Pixel = typename Copy::Value;
  const std::size_t used = static_cast<std::size_t>(image.width) * sizeof(Pixel);
  const auto rows = static_cast<std::size_t>(image.height);
  if (image.row_bytes < used || image.pixels.size() / image.row_bytes < rows)
    throw unsound(source, "an image has fewer bytes than its size requires");
  Copy copy(image.width, image.height);
  for (std::size_t v = 0; v < rows; ++v) {
    std::memcpy(copy.data() + v * static_cast<std::size_t>(image.width),
                image.pixels.data() + v * image.row_bytes, used);
  }
  return copy;
}

bool is_gray(const ImageMessage& image) { return image.encoding == "mono8" || image.encoding == "8UC1"; }

using FourBytes = std::array<std::uint8_t, 4>;
using TwoBytes = std::array<std::uint8_t, 2>;

template <typename Pixel>
ColorImage converted(const ImageMessage& image, int channels, int code, std::string_view source) {
  auto raw = copy_rows<Image<Pixel>>(image, source);
  ColorImage color(image.width, image.height);
  cv::Mat to(image.height, image.width, CV_8UC3, color.data());
  cv::cvtColor(cv::Mat(image.height, image.width, CV_8UC(channels), raw.data()), to, code);
  return color;
}

}  // namespace

int possible_side(std::uint32_t pixels, std::string_view source) {
  if (pixels >= 1 && pixels <= max_color_pixels) return static_cast<int>(pixels);
  throw unsound(source, fmt::format("an image states a side of {} pixels", pixels));
}

void set_size(ImageMessage& image, std::uint32_t width, std::uint32_t height, std::string_view source) {
  image.width = possible_side(width, source);
  image.height = possible_side(height, source);
  if (image.width > max_color_pixels / image.height) {
    throw unsound(source, fmt::format("an image of {}x{} pixels is larger than any camera gives", image.width,
                                      image.height));
  }
}

DepthImage depth_of(const ImageMessage& image, double unit_m, std::string_view source) {
  if (image.width > max_depth_pixels / image.height)
    throw unsound(source, fmt::format("a depth image of {}x{} pixels is larger than any camera gives",
                                      image.width, image.height));
  if (image.encoding == "32FC1") return depth_from_metres(copy_rows<Image<float>>(image, source), unit_m);
  if (image.encoding != "mono16" && image.encoding != "16UC1") throw unknown_encoding(image, "depth", source);
  return copy_rows<DepthImage>(image, source);
}

ColorImage color_of(const ImageMessage& image, std::string_view source) {
  if (image.encoding == "rgb8") return copy_rows<ColorImage>(image, source);
  if (image.encoding == "bgr8") return converted<Rgb>(image, 3, cv::COLOR_BGR2RGB, source);
  if (image.encoding == "rgba8") return converted<FourBytes>(image, 4, cv::COLOR_RGBA2RGB, source);
  if (image.encoding == "bgra8") return converted<FourBytes>(image, 4, cv::COLOR_BGRA2RGB, source);
  if (is_gray(image)) return converted<std::uint8_t>(image, 1, cv::COLOR_GRAY2RGB, source);
  const bool pairs = image.width % 2 == 0;
  if (image.encoding == "YUYV" && pairs) return converted<TwoBytes>(image, 2, cv::COLOR_YUV2RGB_YUYV, source);
  if (image.encoding == "yuv422" && pairs)
    return converted<TwoBytes>(image, 2, cv::COLOR_YUV2RGB_UYVY, source);
  throw unknown_encoding(image, "colour", source);
}

FineGrayImage fine_gray_of(const ImageMessage& image, std::string_view source) {
  if (image.encoding != "mono16") throw unknown_encoding(image, "infrared", source);
  return copy_rows<FineGrayImage>(image, source);
}

GrayImage gray_of(const ImageMessage& image, std::string_view source) {
  if (!is_gray(image)) throw unknown_encoding(image, "infrared", source);
  return copy_rows<GrayImage>(image, source);
}

}  // namespace rva
