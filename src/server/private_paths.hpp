// Paths in messages to consoles.
#pragma once

#include <string>

namespace rva {

/// Shortens the absolute paths in a message: clients need to know which inspection and which capture is
/// meant, but not where this computer keeps its files.
/// @param text a message for the user
/// @return the message with "inspections/000001/final-2/000" for a path in the data folder and "…/name" for
///         other files; devices (/dev/...) are unchanged
[[nodiscard]] std::string without_folders(const std::string& text);

}  // namespace rva
