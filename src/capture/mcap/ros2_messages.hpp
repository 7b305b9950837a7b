// Messages of ROS 2 that an MCAP file of ours consists of, as CDR, and their definitions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// The name of a message type, and its definition with those of the types that it contains, as rosbag2 writes
/// it.
struct MessageType {
  std::string_view name;        ///< "sensor_msgs/msg/Image"
  std::string_view definition;  ///< text in the language of .msg files
};

extern const MessageType image_type;        ///< sensor_msgs/msg/Image
extern const MessageType camera_info_type;  ///< sensor_msgs/msg/CameraInfo
extern const MessageType transforms_type;   ///< tf2_msgs/msg/TFMessage

/// When a message was taken, and the frame that its coordinates are in.
struct MessageHeader {
  std::uint64_t time_ns = 0;  ///< nanoseconds since 1970
  std::string_view frame;     ///< name of the coordinate frame
};

/// The pixels of an image as they lie in memory.
struct RawImage {
  int width = 0;                      ///< px
  int height = 0;                     ///< px
  std::string_view encoding;          ///< "16UC1", "32FC1", "rgb8", "mono16"
  std::span<const std::byte> pixels;  ///< row by row, without padding; little-endian
};

/// A serialised sensor_msgs/msg/Image.
[[nodiscard]] std::vector<std::byte> image_message(const MessageHeader& header, const RawImage& image);

/// Without lens distortion, or with that of Brown and Conrady ("plumb_bob"). Coefficients of the inverse
/// model are left out, since ROS has no name for it.
[[nodiscard]] std::vector<std::byte> camera_info_message(const MessageHeader& header,
                                                         const Intrinsics& camera);

/// One transform: coordinates of the frame `child` in the frame of the header.
[[nodiscard]] std::vector<std::byte> transform_message(const MessageHeader& header, std::string_view child,
                                                       const Transform& header_from_child);

}  // namespace rva
