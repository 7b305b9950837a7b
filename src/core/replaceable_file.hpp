// Files that a command writes.
#pragma once

#include <filesystem>

namespace rva {

/// Checks that a file may be written.
/// @param overwrite whether an earlier file may be replaced; a folder never is
/// @throws ExistsError when something is there that may not be replaced
void require_replaceable(const std::filesystem::path& file, bool overwrite);

}  // namespace rva
