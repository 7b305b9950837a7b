// Reads and checks the fields of a request.
#pragma once

#include <optional>
#include <string>

#include "server/json_of.hpp"

namespace rva {

/// Limits of texts; longer ones are refused.
inline constexpr std::size_t most_field_bytes = 200;
inline constexpr std::size_t most_note_bytes = 4000;
inline constexpr std::size_t most_plan_bytes = 60000;
inline constexpr std::size_t most_list_bytes = 60000;

/// @throws ApiError (400) when the text is not a JSON object, or nested more than a few levels
[[nodiscard]] Json parse_body(const std::string& text);

/// @return the text; empty if the field is missing or null
/// @throws ApiError (400) when the field is not a text, is longer than `most_bytes`, or has control
///         characters other than line feeds and tabs
[[nodiscard]] std::string text_field(const Json& body, const char* key,
                                     std::size_t most_bytes = most_field_bytes);
/// @return the value; false if the field is missing or null
/// @throws ApiError (400) when the field is neither true nor false
[[nodiscard]] bool flag_field(const Json& body, const char* key);
/// @throws ApiError (400) when the field is missing, not a number, or not finite
[[nodiscard]] double number_field(const Json& body, const char* key);

/// @return the value; -1 if it is not a whole number from 0 to 1e9
/// @throws ApiError (400) as number_field()
[[nodiscard]] int count_field(const Json& body, const char* key);

/// @return the field's [x, y, width, height], fractions dropped
/// @throws ApiError (400) when it is not a list of four numbers from 0
[[nodiscard]] Box box_field(const Json& body, const char* key);

/// The number that a part of a path stands for. @return empty if it is no whole number from 0
[[nodiscard]] std::optional<int> number_in_path(const std::string& text);

}  // namespace rva
