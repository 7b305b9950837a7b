// Writes folders in the format of Open3D's recorder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "core/progress.hpp"

namespace rva {

/// The files that such a folder may contain, for an OutputFolder.
[[nodiscard]] std::vector<std::string> open3d_files();

/// Writes intrinsic.json, depth/00000.png, color/00000.jpg, ...: every depth frame, aligned to colour, with
/// its colour image, or else the last one before it (the first of the capture, where there is none before).
/// @param folder must exist
/// @throws Error when the capture has no colour, or states no extrinsics for it; when its colour images have
///         lens distortion, which the format cannot describe; when a frame cannot be read or a file cannot be
///         written; Interrupted
void write_open3d_folder(const Capture& capture, const std::filesystem::path& folder,
                         const Progress& progress);

}  // namespace rva
