// What is on the disk stays there through a power cut.
#pragma once

#include <filesystem>

namespace rva {

/// Returns when the names in a folder are on the disk: a file that was renamed into it is there after a power
/// cut. File systems that cannot do this are left to themselves.
/// @throws Error when the disk fails
void sync_folder(const std::filesystem::path& folder);

/// The same of a folder with all that it holds, file contents included. Links are not followed.
/// @throws Error when the disk fails or something cannot be read
void sync_tree(const std::filesystem::path& folder);

/// Makes a folder and its parents where they are missing; their names are on the disk when it returns.
/// @throws Error when one cannot be made
void make_folders(const std::filesystem::path& folder);

/// Puts a complete folder in an empty place, in one step, and returns when that is on the disk.
/// @param place nothing, or an empty folder
/// @throws Error when there is anything, or the disk refuses; then both are as they were
void move_into_place(const std::filesystem::path& complete, const std::filesystem::path& place);

/// Puts a complete folder in the place of an earlier one, which is found under the name `complete`
/// afterwards: in one step, so that whatever stops the program, the place holds one of the two. File systems
/// that cannot exchange names need three steps; recover_remains() puts the earlier folder back where they
/// were interrupted.
/// @throws Error when the disk refuses; then both are as they were
void exchange(const std::filesystem::path& complete, const std::filesystem::path& place);

}  // namespace rva
