// Databases of rosbag2, as librealsense from version 2.58 on and ROS 2 record them.
#pragma once

#include <filesystem>
#include <memory>

#include "capture/rosbag2/db3_file.hpp"

namespace rva {

/// Opens a rosbag2 database of librealsense or ROS.
/// @throws Error when it is not a database of rosbag2, or cannot be read; Interrupted
[[nodiscard]] std::unique_ptr<Recording> open_db3_recording(const std::filesystem::path& file);

}  // namespace rva
