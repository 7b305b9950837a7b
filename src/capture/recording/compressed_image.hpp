// Compressed images of ROS: sensor_msgs/CompressedImage, as the transports compressedDepth and compressed
// write it.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "capture/recording/image_message.hpp"

namespace rva {

/// Whether messages of this type are compressed images, of ROS 1 or 2.
[[nodiscard]] bool is_compressed_image(std::string_view message_type);

/// The name of the topic without that of its transport: "/camera/depth/image" of
/// "/camera/depth/image/compressedDepth".
[[nodiscard]] std::string_view without_transport(std::string_view topic);

/// Decompresses an image: PNG of 16UC1 and of quantised 32FC1 depth; PNG and JPEG of colour.
/// @param format as the message states it: "16UC1; compressedDepth png", "rgb8; jpeg compressed bgr8"
/// @return an image without a header, in 16UC1, 32FC1 (metres) or rgb8
/// @throws Error when it is damaged or compressed in another way (RVL, for example)
[[nodiscard]] ImageMessage decompressed(std::string_view format, std::span<const std::byte> data,
                                        std::string_view source);

}  // namespace rva
