// The messages that realsense-viewer records (librealsense third-party/realsense-file, src/media/ros).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// sensor_msgs/Image, and what librealsense appends to it. Texts and pixels lie in the message's bytes.
struct ImageMessage {
  std::uint32_t sequence = 0;
  double time_s = 0.0;  ///< by the camera's clock
  int width = 0;        ///< px
  int height = 0;
  std::string_view encoding;  ///< "mono16", "rgb8", ...
  std::size_t row_bytes = 0;
  std::span<const std::byte> pixels;
  std::optional<float> unit_m;  ///< of depth, in files of version 4 and later
};

/// @throws Error when the message ends early, or its image is larger than any camera's; so do all below
[[nodiscard]] ImageMessage parse_image_message(std::span<const std::byte> message, std::string_view place);

/// @throws Error also when the encoding is not one of 16 bits in one channel
[[nodiscard]] DepthImage depth_of(const ImageMessage& image, std::string_view place);

/// From rgb8, bgr8, rgba8, bgra8, mono8, 8UC1, YUYV and yuv422 (UYVY).
/// @throws Error also when the encoding is another
[[nodiscard]] ColorImage color_of(const ImageMessage& image, std::string_view place);

/// @throws Error also when the encoding is neither mono8 nor 8UC1
[[nodiscard]] GrayImage gray_of(const ImageMessage& image, std::string_view place);

/// sensor_msgs/CameraInfo. A lens model that we do not know is none where its coefficients are 0.
/// @throws Error also when no camera can have it, or its lens model is not known
[[nodiscard]] Intrinsics parse_camera_info(std::span<const std::byte> message, std::string_view place);

/// geometry_msgs/Transform: this stream's frame from that of its group. @throws Error also for no rotation
[[nodiscard]] Transform parse_transform_message(std::span<const std::byte> message, std::string_view place);

/// diagnostic_msgs/KeyValue
[[nodiscard]] std::pair<std::string, std::string> parse_key_value(std::span<const std::byte> message,
                                                                  std::string_view place);

/// std_msgs/Float32, as the shortest decimal number that reads back as the same: 0.001, not 0.0010000000475.
[[nodiscard]] double parse_float(std::span<const std::byte> message, std::string_view place);
[[nodiscard]] double shortest_decimal(float value);

}  // namespace rva
