// The names of a model's classes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rva {

/// Reads a labels file: the name of one class a line, in UTF-8, in the order of the model's classes. Blanks
/// around a name and empty lines at the end are ignored.
/// @return at least one name; each is different
/// @throws Error when the file cannot be read, is not UTF-8, has no names, or has an empty line or a name
/// twice
[[nodiscard]] std::vector<std::string> read_labels(const std::filesystem::path& file);

}  // namespace rva
