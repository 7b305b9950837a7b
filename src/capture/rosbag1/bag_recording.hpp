// ROS bags, as librealsense up to version 2.57 and ROS 1 record them.
#pragma once

#include <filesystem>
#include <memory>

#include "capture/recording/recording.hpp"

namespace rva {

/// Opens a ROS bag of librealsense or ROS.
/// @throws Error when it is not a bag of version 2.0, or cannot be read; Interrupted
[[nodiscard]] std::unique_ptr<Recording> open_bag_recording(const std::filesystem::path& file);

}  // namespace rva
