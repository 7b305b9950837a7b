// The space of a folder's disk, and whether files can be written into the folder.
#pragma once

#include <cstdint>
#include <filesystem>

namespace rva {

/// The disk on which a folder is.
struct FolderSpace {
  std::uintmax_t free_bytes = 0;  ///< that this program may still write
  std::uintmax_t size_bytes = 0;  ///< of the whole disk
};

/// @throws Error when the system does not state it, as for a folder that does not exist
[[nodiscard]] FolderSpace space_of(const std::filesystem::path& folder);

/// Checks that a file can be created in a folder and written. Nothing is left in it, also if the program is
/// killed meanwhile.
/// @throws Error when it cannot: no such folder, no permission, a read-only or a full disk
void require_writable(const std::filesystem::path& folder);

}  // namespace rva
