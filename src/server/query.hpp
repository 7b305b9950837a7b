// The query of a request: what follows the question mark of its address.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace rva {

/// Values by key, decoded. Of a key that occurs twice, the last value applies.
using QueryValues = std::map<std::string, std::string>;

/// Splits `key=value&...` and decodes percent escapes and plus signs, as a form encodes them.
/// @throws ApiError (400) when an escape is malformed, or a text is longer than most_field_bytes or has
///         control characters
[[nodiscard]] QueryValues query_values(std::string_view query);

}  // namespace rva
