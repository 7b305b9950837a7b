// One description per option, from which the command line, the files, the checks and the documentation
// are made.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "core/error.hpp"

namespace rva {

/// The description of one field of an options struct.
///
/// An options struct has plain fields with defaults and a static `describe(self, visit)` that calls
/// `visit(self.field, OptionField{...})` for each, in the order of the documentation.
struct OptionField {
  std::string_view name;  ///< as on the command line, without dashes: "min-blob"
  std::string_view unit;  ///< "m", "px", ""; files append it to the name: "threshold_m"
  double min;             ///< least allowed value
  double max;             ///< largest allowed value
  std::string_view help;  ///< one sentence, without a full stop
};

/// The field's name in JSON: `min-blob` in px is "min_blob_px".
inline std::string json_name(const OptionField& field) {
  std::string name(field.name);
  for (char& character : name) {
    if (character == '-') character = '_';
  }
  if (!field.unit.empty()) name += fmt::format("_{}", field.unit);
  return name;
}

/// An option is out of range, or does not go with others. Its source is the option's name, as OptionField has
/// it: `rva`, whose flags have these names, prints it with dashes.
class OptionError : public UsageError {
 public:
  using UsageError::UsageError;
};

/// @throws OptionError stating the bounds and the unit when a field is out of bounds or not a number
template <typename Options>
void check_options(const Options& options) {
  Options::describe(options, [](const auto& value, const OptionField& field) {
    const auto number = static_cast<double>(value);
    if (number >= field.min && number <= field.max) return;  // false for NaN
    throw OptionError(
        std::string(field.name), fmt::format("{} is out of range", number),
        fmt::format("give {} to {}{}{}", field.min, field.max, field.unit.empty() ? "" : " ", field.unit));
  });
}

}  // namespace rva
