// The messages that librealsense records into bags (its third-party/realsense-file, src/media/ros).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "capture/recording/image_message.hpp"
#include "capture/recording/static_transforms.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// Parses sensor_msgs/Image and the depth unit that librealsense appends to it in files of version 4
/// and later.
/// @param source the file's name, for errors, here and below
/// @throws Error when the message ends early (so do all functions below), or its image is larger than
///         any camera's
[[nodiscard]] ImageMessage parse_image_message(std::vector<std::byte> message, std::string_view source);

/// Parses and decompresses sensor_msgs/CompressedImage. @throws Error also as decompressed()
[[nodiscard]] ImageMessage parse_compressed_message(std::span<const std::byte> message,
                                                    std::string_view source);

/// Parses sensor_msgs/CameraInfo. @throws Error also as with_lens()
[[nodiscard]] Intrinsics parse_camera_info(std::span<const std::byte> message, std::string_view source);

/// Parses geometry_msgs/Transform: stream from group. @throws Error also when it is not a rigid transform
[[nodiscard]] Transform parse_transform_message(std::span<const std::byte> message, std::string_view source);

/// Parses tf2_msgs/TFMessage. @throws Error also when one is not a rigid transform
[[nodiscard]] std::vector<StaticTransform> parse_transforms(std::span<const std::byte> message,
                                                            std::string_view source);

/// Parses diagnostic_msgs/KeyValue.
[[nodiscard]] std::pair<std::string, std::string> parse_key_value(std::span<const std::byte> message,
                                                                  std::string_view source);

/// Parses std_msgs/Float32, as the shortest decimal number that rounds to it: 0.001, not 0.0010000000475.
[[nodiscard]] double parse_float(std::span<const std::byte> message, std::string_view source);

}  // namespace rva
