// Streams of a camera's node in ROS, told by what its topics hold.
#pragma once

#include <optional>
#include <string>

#include "depth/recording/streams.hpp"

namespace rva {

/// The depth images are those of 16 bits or floating point in one channel (REP 118: millimetres or metres),
/// if there are several not those that were aligned to colour; colour and infrared images are those of the
/// same camera. Each has its intrinsics beside it, in `camera_info`.
/// @param depth_topic instead of the one that would be chosen
/// @return empty when no topic holds depth
/// @throws Error when `depth_topic` holds no depth
[[nodiscard]] std::optional<RecordedStreams> find_ros_streams(const Recording& recording,
                                                              const std::optional<std::string>& depth_topic);

}  // namespace rva
