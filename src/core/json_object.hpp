// Reading JSON that people wrote: every complaint names the file and the field.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rva {

/// @throws Error naming the line where the text is not JSON, or holds bytes that are not UTF-8
[[nodiscard]] nlohmann::json parse_json(const std::string& text, const std::string& place);

/// An object inside a JSON document that knows where it stands. Keys nobody asks for are ignored.
/// Refers to the document: keep that alive.
class JsonObject {
 public:
  /// @param place the file
  /// @param field dotted name of this object in it, empty for the whole document
  /// @throws Error when the value is not an object
  JsonObject(const nlohmann::json& value, std::string place, std::string field = {});

  [[nodiscard]] bool has(const char* key) const;  ///< false also for null
  [[nodiscard]] std::vector<std::string> keys() const;

  // Each throws an Error when the key is missing or holds another type; integer() also for a number that is
  // fractional or does not fit.
  [[nodiscard]] double number(const char* key) const;
  [[nodiscard]] int integer(const char* key) const;
  [[nodiscard]] bool boolean(const char* key) const;
  [[nodiscard]] std::string string(const char* key) const;
  [[nodiscard]] JsonObject object(const char* key) const;
  [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count) const;

  /// As the above, empty where the key is missing.
  [[nodiscard]] std::optional<double> optional_number(const char* key) const;
  [[nodiscard]] std::optional<std::string> optional_string(const char* key) const;
  [[nodiscard]] std::optional<JsonObject> optional_object(const char* key) const;

  /// "file: depth.fx", for errors about what was read.
  [[nodiscard]] std::string name_of(std::string_view key) const;

 private:
  [[nodiscard]] const nlohmann::json& at(const char* key) const;

  const nlohmann::json* value_;
  std::string place_;
  std::string field_;
};

}  // namespace rva
