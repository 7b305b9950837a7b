// The messages that librealsense records into bags (its third-party/realsense-file, src/media/ros).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "depth/recording/image_message.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// sensor_msgs/Image, and what librealsense appends to it: the unit, in files of version 4 and later.
/// @throws Error when the message ends early, or its image is larger than any camera's; so do all below
[[nodiscard]] ImageMessage parse_image_message(std::vector<std::byte> message, std::string_view place);

/// sensor_msgs/CameraInfo. @throws Error also as with_lens()
[[nodiscard]] Intrinsics parse_camera_info(std::span<const std::byte> message, std::string_view place);

/// geometry_msgs/Transform: this stream's frame from that of its group. @throws Error also for no rotation
[[nodiscard]] Transform parse_transform_message(std::span<const std::byte> message, std::string_view place);

/// diagnostic_msgs/KeyValue
[[nodiscard]] std::pair<std::string, std::string> parse_key_value(std::span<const std::byte> message,
                                                                  std::string_view place);

/// std_msgs/Float32, as the shortest decimal number that reads back as the same: 0.001, not 0.0010000000475.
[[nodiscard]] double parse_float(std::span<const std::byte> message, std::string_view place);

}  // namespace rva
