// Paths as text for messages and JSON.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rva {

/// True when the bytes are well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates).
[[nodiscard]] bool is_utf8(std::string_view bytes);

/// The path for a message: control characters, marks of the writing direction among them, and bytes that are
/// not UTF-8 appear as `\xNN`, so that the line stays one line and a terminal shows it in this order.
[[nodiscard]] std::string printable(const std::filesystem::path& path);

/// Refuses a path whose bytes are not UTF-8: it could not be written into a record or shown on a page.
/// @throws Error
void require_utf8(const std::filesystem::path& path);

}  // namespace rva
