// Writing what Open3D's recorder writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "depth/capture.hpp"

namespace rva {

/// What such a folder may hold, for an OutputFolder.
[[nodiscard]] std::vector<std::string> open3d_files();

/// intrinsic.json, depth/00000.png, color/00000.jpg, ...: every depth frame, aligned to colour, with the
/// colour image that was taken last.
/// @param folder exists
/// @throws Error when the capture has no colour, or colour through a lens that bends rays, which such a
/// folder
///         cannot say; when a frame cannot be read or a file not be written; Interrupted
void write_open3d_folder(const Capture& capture, const std::filesystem::path& folder,
                         const Progress& progress);

}  // namespace rva
