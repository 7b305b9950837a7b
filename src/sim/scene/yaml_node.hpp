// Reading YAML that people wrote: every complaint names the file, the line and the field.
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace rva {

/// What a number may be, both ends included.
struct NumberRange {
  double low;
  double high;
};

/// A value inside a YAML document that knows where it stands. Copies refer to the same document.
/// All reading members throw an Error when the value is of another type or out of range.
class YamlNode {
 public:
  /// @param place the file, fit for a message
  /// @throws Error naming the line where the text is not YAML, or when it is not one document
  [[nodiscard]] static YamlNode parse(const std::string& text, const std::string& place);

  /// "file:line"
  [[nodiscard]] std::string place() const;
  [[nodiscard]] Error error(std::string_view problem, std::string remedy = "correct the file") const;

  // Maps.
  /// Refuses a value that is not a map, keys that are not listed, and keys given twice.
  void allow_only(std::initializer_list<std::string_view> keys) const;
  [[nodiscard]] bool has(const char* key) const;
  [[nodiscard]] YamlNode at(const char* key) const;
  [[nodiscard]] std::optional<YamlNode> find(const char* key) const;

  // Lists; an empty value is an empty list.
  [[nodiscard]] std::vector<YamlNode> items() const;
  [[nodiscard]] std::vector<double> numbers(std::size_t count, NumberRange range) const;

  // Single values.
  [[nodiscard]] double number(NumberRange range) const;
  [[nodiscard]] int integer(int low, int high) const;
  [[nodiscard]] std::uint64_t seed() const;  ///< any whole number from 0
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string text() const;  ///< never empty
  /// Which of the names the value is; @param what for the complaint: "material"
  [[nodiscard]] std::size_t choice(std::string_view what, std::span<const std::string_view> names) const;

  /// As the above, leaving `value` as it is where the key is missing.
  void read(const char* key, double& value, NumberRange range) const;
  void read(const char* key, int& value, int low, int high) const;
  void read(const char* key, bool& value) const;

 private:
  YamlNode(const YAML::Node& node, std::shared_ptr<const std::string> file, std::string field);
  [[nodiscard]] YamlNode child(const YAML::Node& node, std::string_view key) const;
  [[nodiscard]] std::string scalar(std::string_view kind) const;

  YAML::Node node_;
  std::shared_ptr<const std::string> file_;
  std::string field_;  ///< dotted name, empty for the whole document
};

}  // namespace rva
