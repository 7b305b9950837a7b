// Images as librealsense's recorders keep them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// sensor_msgs/Image, and what goes with it.
struct ImageMessage {
  std::vector<std::byte> message;  ///< what the texts and the pixels lie in
  std::optional<std::uint64_t> counter;
  std::optional<double> time_s;  ///< by the camera's clock
  int width = 0;                 ///< px
  int height = 0;
  std::string_view encoding;  ///< "mono16", "rgb8", ...
  std::size_t row_bytes = 1;
  std::span<const std::byte> pixels;
  std::optional<double> unit_m;  ///< of depth, where it is stated with each image

  ImageMessage() = default;
  ~ImageMessage() = default;
  ImageMessage(ImageMessage&&) = default;
  ImageMessage& operator=(ImageMessage&&) = default;
  ImageMessage(const ImageMessage&) = delete;  // its texts and pixels would lie in another's bytes
  ImageMessage& operator=(const ImageMessage&) = delete;
};

/// Sides as a message states them. @throws Error when no camera's image is as large, or it has no pixel
void set_size(ImageMessage& image, std::uint32_t width, std::uint32_t height, std::string_view place);

/// A side by itself, of an image or of intrinsics. @throws Error as above
[[nodiscard]] int possible_side(std::uint32_t pixels, std::string_view place);

/// @throws Error when the encoding is not one of 16 bits in one channel, or there are too few bytes, as below
[[nodiscard]] DepthImage depth_of(const ImageMessage& image, double unit_m, std::string_view place);

/// From rgb8, bgr8, rgba8, bgra8, mono8, 8UC1, YUYV and yuv422 (UYVY). @throws Error for another
[[nodiscard]] ColorImage color_of(const ImageMessage& image, std::string_view place);

/// From mono8 and 8UC1. @throws Error for another
[[nodiscard]] GrayImage gray_of(const ImageMessage& image, std::string_view place);

}  // namespace rva
