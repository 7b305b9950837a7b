// What a request says, checked.
#pragma once

#include <string>

#include "server/json_of.hpp"

namespace rva {

/// Names and numbers of things; longer ones are refused.
inline constexpr std::size_t most_field_bytes = 200;
inline constexpr std::size_t most_note_bytes = 4000;

/// @throws ApiError (400) when the text is not a JSON object, or nested more than a few levels
[[nodiscard]] Json parse_body(const std::string& text);

/// @return empty where the field is missing @throws ApiError (400) when it is no text, is longer, or has
/// control characters other than line feeds and tabs
[[nodiscard]] std::string text_field(const Json& body, const char* key,
                                     std::size_t most_bytes = most_field_bytes);
/// @return false where the field is missing @throws ApiError (400) when it is neither true nor false
[[nodiscard]] bool flag_field(const Json& body, const char* key);
/// @throws ApiError (400) when it is missing, no number, or not finite
[[nodiscard]] double number_field(const Json& body, const char* key);

}  // namespace rva
