// Reading JSON that users may have written, so that every error names the file and the field; writing JSON as
// text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rva {

/// Parses JSON.
/// @param source the file's name, for errors
/// @throws Error when the text is not JSON or not UTF-8, naming the line; when a number does not fit a double
[[nodiscard]] nlohmann::json parse_json(const std::string& text, const std::string& source);

/// JSON as text. Bytes that are not UTF-8, as names of files and devices may have, become U+FFFD.
/// @param indent spaces for each level; below 0, everything is in one line
[[nodiscard]] std::string json_text(const nlohmann::json& json, int indent = -1);
/// @overload
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json, int indent = -1);

/// The content of a file: JSON as text, with a line feed at the end.
[[nodiscard]] std::string json_file_text(const nlohmann::ordered_json& json, int indent = 1);

/// An object inside a JSON document, with its location there for errors. Keys that are not read are ignored.
/// The document must outlive it.
class JsonObject {
 public:
  /// @param source the file's name, for errors
  /// @param field dotted name of this object in it, empty for the whole document
  /// @throws Error when the value is not an object
  JsonObject(const nlohmann::json& value, std::string source, std::string field = {});

  [[nodiscard]] bool has(const char* key) const;  ///< false also for null
  /// All keys, in alphabetical order.
  [[nodiscard]] std::vector<std::string> keys() const;

  /// @name Required values
  /// Each throws an Error when the key is missing or its value has another type; integer() also when the
  /// number is fractional or out of range.
  /// @{

  /// A number.
  [[nodiscard]] double number(const char* key) const;
  /// A whole number, beyond -2e9 and below 2e9.
  [[nodiscard]] int integer(const char* key) const;
  /// A truth value.
  [[nodiscard]] bool boolean(const char* key) const;
  /// A text.
  [[nodiscard]] std::string string(const char* key) const;
  /// An object in this one, which refers to the same document.
  [[nodiscard]] JsonObject object(const char* key) const;
  /// An array of exactly `count` numbers.
  [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count) const;

  /// @}

  /// Empty where the key is missing or null. @throws Error when the value has another type
  [[nodiscard]] std::optional<double> optional_number(const char* key) const;
  /// A text; see optional_number() for errors.
  [[nodiscard]] std::optional<std::string> optional_string(const char* key) const;
  /// An object; see optional_number() for errors.
  [[nodiscard]] std::optional<JsonObject> optional_object(const char* key) const;

  /// "file: depth.fx", for errors about the value of a key.
  [[nodiscard]] std::string name_of(std::string_view key) const;

 private:
  [[nodiscard]] const nlohmann::json& at(const char* key) const;

  const nlohmann::json* value_;
  std::string source_;
  std::string field_;
};

}  // namespace rva
