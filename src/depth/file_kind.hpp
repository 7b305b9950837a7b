// What a file is that is no recording, so that a person learns why it cannot be opened.
#pragma once

#include <filesystem>
#include <string_view>

namespace rva {

/// False also for what is no regular file: reading a pipe would wait for its other end.
[[nodiscard]] bool begins_with(const std::filesystem::path& file, std::string_view magic);

/// Refuses what is certainly no recording of a camera, by its first bytes: an empty file, a Git LFS pointer,
/// an archive, a point cloud, a video, a single image. What is no regular file is not read.
/// @throws Error that names what it is and what to do; also when the file cannot be read
void require_recording(const std::filesystem::path& file);

}  // namespace rva
