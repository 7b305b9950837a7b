// MCAP files with messages of ROS.
#pragma once

#include <filesystem>
#include <memory>

#include "depth/recording/recording.hpp"

namespace rva {

/// True when the file begins as an MCAP file does.
[[nodiscard]] bool is_mcap_file(const std::filesystem::path& path);

/// Frames are read when they are asked for.
/// @throws Error when the file is no MCAP file or cannot be read; Interrupted
[[nodiscard]] std::unique_ptr<Recording> open_mcap_recording(const std::filesystem::path& file);

}  // namespace rva
