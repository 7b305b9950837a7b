// The messages that librealsense records into databases of rosbag2 (its src/media/ros2, version 2.58).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "capture/recording/recording.hpp"
#include "capture/recording/static_transforms.hpp"

namespace rva {

/// Parses sensor_msgs/msg/Image. Its header has the time of the recording, not the camera's, so that time_s
/// is left empty.
/// @param source the file's name, for errors, here and below
/// @throws Error when the message ends early, or its image is larger than any camera's
[[nodiscard]] ImageMessage parse_db3_image(std::vector<std::byte> message, std::string_view source);

/// Parses and decompresses sensor_msgs/msg/CompressedImage. @throws Error also as decompressed()
[[nodiscard]] ImageMessage parse_db3_compressed(std::span<const std::byte> message, std::string_view source);

/// Parses std_msgs/msg/String. @throws Error when it ends early
[[nodiscard]] std::string parse_db3_text(std::span<const std::byte> message, std::string_view source);

/// Parses "key=value;key=value" in a std_msgs/msg/String, which is the format of everything but images.
/// @throws Error when it ends early
[[nodiscard]] KeyValues parse_db3_values(std::span<const std::byte> message, std::string_view source);

/// Parses sensor_msgs/msg/CameraInfo, as ROS records it. @throws Error when it ends early; as with_lens()
[[nodiscard]] Intrinsics parse_db3_camera_info(std::span<const std::byte> message, std::string_view source);

/// Parses tf2_msgs/msg/TFMessage. @throws Error when it ends early, or one is not a rigid transform
[[nodiscard]] std::vector<StaticTransform> parse_db3_transforms(std::span<const std::byte> message,
                                                                std::string_view source);

/// Intrinsics from the keys width, height, fx, fy, ppx, ppy, coeffs and, optionally, model.
/// @throws Error when a key is missing; as with_lens()
[[nodiscard]] Intrinsics intrinsics_from(const KeyValues& values, std::string_view source);

/// The transform to a stream's frame from that of its group, from the keys rotation (column by column) and
/// translation (metres). @throws Error when it is not a rigid transform
[[nodiscard]] Transform transform_from(const KeyValues& values, std::string_view source);

}  // namespace rva
