// Points in time as text.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace rva {

/// ISO 8601 in UTC, to the millisecond: "2026-01-01T00:00:00.000Z".
[[nodiscard]] std::string iso_8601(std::chrono::system_clock::time_point moment);

/// Nanoseconds since 1970 of a text as iso_8601() writes it, with or without fractions of a second; empty for
/// any other text.
[[nodiscard]] std::optional<std::uint64_t> ns_since_1970(const std::string& text);

/// The present time as iso_8601() writes it.
[[nodiscard]] inline std::string iso_8601_now() { return iso_8601(std::chrono::system_clock::now()); }

}  // namespace rva
