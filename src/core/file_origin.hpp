// What a result states about its own making.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rva {

/// When a result was made: now, or, so that its bytes are repeatable, the time that the environment's
/// SOURCE_DATE_EPOCH states in seconds since 1970. ISO 8601 in UTC.
/// @throws Error when SOURCE_DATE_EPOCH is set and no such number
[[nodiscard]] std::string time_of_making();

/// The beginning of `provenance` in a result: `program`, `version` and `created_at`.
[[nodiscard]] nlohmann::ordered_json provenance_json(const std::string& created_at);

}  // namespace rva
