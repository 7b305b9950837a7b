// Image messages of recordings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// A sensor_msgs/Image, and metadata that the recorder stores with it.
struct ImageMessage {
  std::vector<std::byte> message;        ///< storage of the texts and the pixels
  std::optional<std::uint64_t> counter;  ///< the camera's frame number; empty where the recording states none
  std::optional<double> time_s;          ///< by the camera's clock
  std::string frame;                     ///< name of the coordinate frame, as ROS states it
  int width = 0;                         ///< px
  int height = 0;                        ///< px
  std::string_view encoding;             ///< "mono16", "rgb8", ...
  std::size_t row_bytes = 1;             ///< from the beginning of one row to that of the next
  std::span<const std::byte> pixels;     ///< refers to `message`
  std::optional<double> unit_m;          ///< of depth, where the recording states it with each image

  ImageMessage() = default;
  ~ImageMessage() = default;
  ImageMessage(ImageMessage&&) = default;
  ImageMessage& operator=(ImageMessage&&) = default;
  ImageMessage(const ImageMessage&) = delete;  // its texts and pixels would refer to the other's bytes
  ImageMessage& operator=(const ImageMessage&) = delete;
};

/// Sets the stated size. @throws Error when it is larger than any camera's, or a side is 0
void set_size(ImageMessage& image, std::uint32_t width, std::uint32_t height, std::string_view source);

/// Checks one side of an image, or of intrinsics. @throws Error as set_size()
[[nodiscard]] int possible_side(std::uint32_t pixels, std::string_view source);

/// Converts from mono16, 16UC1 and 32FC1 (metres) to depth units of `unit_m` metres; 16-bit values are kept.
/// @throws Error for another encoding, or too few bytes; so do the functions below
[[nodiscard]] DepthImage depth_of(const ImageMessage& image, double unit_m, std::string_view source);

/// Converts from rgb8, bgr8, rgba8, bgra8, mono8, 8UC1, YUYV and yuv422 (UYVY).
[[nodiscard]] ColorImage color_of(const ImageMessage& image, std::string_view source);

/// Converts from mono16 in 256ths of a grey level, as in recordings that RVA wrote.
[[nodiscard]] FineGrayImage fine_gray_of(const ImageMessage& image, std::string_view source);

/// Converts from mono8 and 8UC1.
[[nodiscard]] GrayImage gray_of(const ImageMessage& image, std::string_view source);

}  // namespace rva
