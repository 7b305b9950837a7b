// What a console is told of files.
#pragma once

#include <string>

namespace rva {

/// Absolute paths without the folders that lead to the data: a visitor needs not know where this computer
/// keeps its files, but which inspection and which capture is meant.
/// @param text a message for a person
/// @return "inspections/000001/final-2/000: ..." of what lies in the data folder, "…/name" of other files;
/// devices (/dev/...)
///         as they are
[[nodiscard]] std::string without_folders(const std::string& text);

}  // namespace rva
