// Reading of YAML files written by hand: every error names the file, the line and the field.
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

/// The valid range of a number, both ends included.
struct NumberRange {
  double low;   ///< least value
  double high;  ///< largest value
};

/// A value inside a YAML document, with its line and field name. Copies refer to the same document.
/// All reading members throw an Error if the value is of another type or out of range.
class YamlNode {
 public:
  /// Parses a document.
  /// @param source printable path of the file, for messages
  /// @throws Error naming the line if the text is not YAML, or not exactly one document
  [[nodiscard]] static YamlNode parse(const std::string& text, const std::string& source);

  /// Position of the value for a message: "file:line".
  [[nodiscard]] std::string source() const;
  /// An Error with the line and the field of this value.
  /// @param problem without a full stop
  [[nodiscard]] Error error(std::string_view problem, std::string remedy = "correct the file") const;

  /// @name Maps
  /// @{

  /// Refuses a value that is not a map, keys that are not listed, and keys given twice.
  void allow_only(std::initializer_list<std::string_view> keys) const;
  /// Whether the value is a map with this key; never throws.
  [[nodiscard]] bool has(const char* key) const;
  /// The value of a key. @throws Error when the key is missing
  [[nodiscard]] YamlNode at(const char* key) const;
  /// The value of a key; empty if it is missing.
  [[nodiscard]] std::optional<YamlNode> find(const char* key) const;

  /// @}

  /// @name Lists
  /// An empty value is an empty list.
  /// @{

  /// The entries of a list.
  [[nodiscard]] std::vector<YamlNode> items() const;
  /// A list of exactly `count` numbers.
  [[nodiscard]] std::vector<double> numbers(std::size_t count, NumberRange range) const;

  /// @}

  /// @name Single values
  /// @{

  /// A number within the range.
  [[nodiscard]] double number(NumberRange range) const;
  /// A whole number from `low` to `high`.
  [[nodiscard]] int integer(int low, int high) const;
  [[nodiscard]] std::uint64_t seed() const;  ///< any whole number from 0 to 2^64 - 1
  /// `true` or `false`.
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string text() const;  ///< never empty
  /// The index of the value in `names`.
  /// @param what the kind of thing for the message, such as "material"
  [[nodiscard]] std::size_t choice(std::string_view what, std::span<const std::string_view> names) const;

  /// @}

  /// Read the field `key` of a map into `value`, which is unchanged if the key is missing.
  void read(const char* key, double& value, NumberRange range) const;
  /// @overload
  void read(const char* key, int& value, int low, int high) const;
  /// @overload
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
