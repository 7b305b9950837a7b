// Recognises files that are not recordings, so that an error can name what they are.
#pragma once

#include <filesystem>
#include <string_view>

namespace rva {

/// Whether a regular file begins with these bytes. Others are not read: a pipe would wait for its writer.
[[nodiscard]] bool begins_with(const std::filesystem::path& file, std::string_view magic);

/// Refuses files that are certainly not recordings of a camera, by their first bytes: an empty file, a Git
/// LFS pointer, an archive, a point cloud, a video, a single image. Only regular files are read.
/// @throws Error that names what the file is and what to do; also when the file cannot be read
void require_recording(const std::filesystem::path& file);

}  // namespace rva
