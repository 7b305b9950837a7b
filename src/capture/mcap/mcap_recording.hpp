// MCAP files with ROS messages.
#pragma once

#include <filesystem>
#include <memory>

#include "capture/recording/recording.hpp"

namespace rva {

/// Whether the file begins as an MCAP file does.
[[nodiscard]] bool is_mcap_file(const std::filesystem::path& path);

/// Opens a recording, whose frames are read on request.
/// @throws Error when the file is not an MCAP file or cannot be read; Interrupted
[[nodiscard]] std::unique_ptr<Recording> open_mcap_recording(const std::filesystem::path& file);

}  // namespace rva
