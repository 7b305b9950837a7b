// Exports a capture of any format as an MCAP file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "core/progress.hpp"

namespace rva {

/// Writes all frames of a capture.
/// @return remarks for the user on what could not be written; sentences without a full stop
/// @throws Error when a frame cannot be read or written; Interrupted
[[nodiscard]] std::vector<std::string> write_mcap(const Capture& capture, const std::filesystem::path& file,
                                                  const Progress& progress);

}  // namespace rva
