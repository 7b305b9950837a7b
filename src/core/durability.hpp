// File operations whose results survive a power cut.
#pragma once

#include <filesystem>

namespace rva {

/// Returns when the names in a folder are on the disk, so that a file renamed into it is still there after a
/// power cut. Has no effect on file systems that do not support this.
/// @throws Error when the disk fails
void sync_folder(const std::filesystem::path& folder);

/// Does the same for a folder and everything in it, file contents included. Links are not followed.
/// @throws Error when the disk fails or something cannot be read
void sync_tree(const std::filesystem::path& folder);

/// Creates a folder and its parents where they are missing; their names are on the disk when it returns.
/// @throws Error when one cannot be created
void make_folders(const std::filesystem::path& folder);

/// Renames a complete folder to `target` in one step, and returns when that is on the disk.
/// @param source a path that does not exist, or an empty folder
/// @throws Error when something else is there, or the system refuses; both are then unchanged
void move_into_place(const std::filesystem::path& complete, const std::filesystem::path& source);

/// Exchanges a complete folder with an earlier one at `target`, which has the name `complete` afterwards.
/// This is one step, so that `target` is always one of the two, whatever stops the program. File systems that
/// cannot exchange names need three steps; if these are interrupted, recover_remains() puts the earlier
/// folder back.
/// @throws Error when the system refuses; both are then unchanged
void exchange(const std::filesystem::path& complete, const std::filesystem::path& source);

}  // namespace rva
