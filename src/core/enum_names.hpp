// Names of the values of enumerations, as files, messages and options have them.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <string_view>

namespace rva {

/// One value of an enumeration, with its name.
template <typename Value>
struct EnumName {
  Value value;            ///< of the enumeration
  std::string_view name;  ///< in files, options and messages
};

/// Every value of an enumeration with its name, in the order of lists for users. An enumeration that has
/// names specialises it right after its definition:
///
///     template <>
///     inline constexpr auto enum_names<Side> =
///         std::to_array<EnumName<Side>>({{Side::initial, "initial"}, {Side::final, "final"}});
template <typename Value>
inline constexpr std::array<EnumName<Value>, 0> enum_names{};

/// The name of a value, which must be in the table of its enumeration.
template <typename Value>
[[nodiscard]] constexpr std::string_view name_of(Value value) {
  static_assert(!enum_names<Value>.empty(), "the enumeration has no names");
  const auto named = std::ranges::find(enum_names<Value>, value, &EnumName<Value>::value);
  assert(named != enum_names<Value>.end());
  return named->name;
}

/// Empty where no value has this name.
template <typename Value>
[[nodiscard]] constexpr std::optional<Value> value_of(std::string_view name) {
  static_assert(!enum_names<Value>.empty(), "the enumeration has no names");
  const auto named = std::ranges::find(enum_names<Value>, name, &EnumName<Value>::name);
  return named == enum_names<Value>.end() ? std::nullopt : std::optional(named->value);
}

/// All names of an enumeration, in the order of its table.
template <typename Value>
[[nodiscard]] constexpr auto names_of() {
  std::array<std::string_view, enum_names<Value>.size()> names;
  std::ranges::transform(enum_names<Value>, names.begin(), &EnumName<Value>::name);
  return names;
}

}  // namespace rva
