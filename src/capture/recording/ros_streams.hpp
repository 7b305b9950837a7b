// The streams of a camera's ROS node, recognised by the contents of its topics.
#pragma once

#include <optional>
#include <string>

#include "capture/recording/streams.hpp"

namespace rva {

/// Finds the topics of a camera's images. Depth images have one channel of 16 bits or floating point (REP
/// 118: millimetres or metres); where there are several, those not aligned to colour are preferred. Colour
/// and infrared images are those of the same camera. The intrinsics of each are in `camera_info` beside it.
/// @param depth_topic the topic of depth images, instead of the one chosen automatically
/// @return empty when no topic has depth images
/// @throws Error when `depth_topic` has no depth images
[[nodiscard]] std::optional<RecordedStreams> find_ros_streams(const Recording& recording,
                                                              const std::optional<std::string>& depth_topic);

}  // namespace rva
