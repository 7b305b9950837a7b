// The messages that librealsense records into databases of rosbag2 (its src/media/ros2, version 2.58).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "depth/recording/recording.hpp"

namespace rva {

/// sensor_msgs/msg/Image. Its header's time is that of the recording, so time_s is left out.
/// @throws Error when the message ends early, or its image is larger than any camera's
[[nodiscard]] ImageMessage parse_db3_image(std::vector<std::byte> message, std::string_view place);

/// std_msgs/msg/String. @throws Error when it ends early
[[nodiscard]] std::string parse_db3_text(std::span<const std::byte> message, std::string_view place);

/// "key=value;key=value" in a std_msgs/msg/String: all that is no image. @throws Error as above
[[nodiscard]] KeyValues parse_db3_values(std::span<const std::byte> message, std::string_view place);

/// sensor_msgs/msg/CameraInfo, as ROS records it. @throws Error when it ends early; as with_lens()
[[nodiscard]] Intrinsics parse_db3_camera_info(std::span<const std::byte> message, std::string_view place);

/// From width, height, fx, fy, ppx, ppy, model, coeffs. @throws Error where one is missing; as with_lens()
[[nodiscard]] Intrinsics intrinsics_from(const KeyValues& values, std::string_view place);

/// From rotation, by columns, and translation in metres: this stream's frame from that of its group.
/// @throws Error for no rotation
[[nodiscard]] Transform transform_from(const KeyValues& values, std::string_view place);

}  // namespace rva
