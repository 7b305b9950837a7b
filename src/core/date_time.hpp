// Points in time as text.
#pragma once

#include <chrono>
#include <string>

namespace rva {

/// ISO 8601 in UTC, to the millisecond: "2026-01-01T00:00:00.000Z".
[[nodiscard]] std::string iso_8601(std::chrono::system_clock::time_point moment);

[[nodiscard]] inline std::string iso_8601_now() { return iso_8601(std::chrono::system_clock::now()); }

}  // namespace rva
