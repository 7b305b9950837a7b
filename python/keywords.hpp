// Keyword arguments of the module's functions. A function describes each of them once: its name, the variable
// with its default, and a sentence. The values that a call gives, the signature and the description that
// Python shows are made from that.
//
// The arguments of a function are a struct with a static `describe_keywords(self, visit)` that calls
// `visit(name, self.variable, sentence)` for each. What an options struct of the library has is visited by
// visit_options(), so that names, defaults and ranges are those of the command line.
#pragma once

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/options.hpp"

namespace rva::python {

/// An option's name as a keyword: `min-blob` is `min_blob`.
[[nodiscard]] inline std::string keyword_name(std::string_view option) {
  std::string name(option);
  for (char& character : name) {
    if (character == '-') character = '_';
  }
  return name;
}

/// Visits each field of an options struct as a keyword argument.
template <typename Options, typename Visit>
void visit_options(Options& options, const Visit& visit) {
  std::remove_const_t<Options>::describe(options, [&](auto& value, const OptionField& field) {
    const std::string unit = field.unit.empty() ? "" : fmt::format(" {}", field.unit);
    visit(keyword_name(field.name), value,
          fmt::format("{} ({} to {}{})", field.help, field.min, field.max, unit));
  });
}

/// Takes the values that a call gives. @return their names
/// @throws TypeError of Python when one has another type, or a name is unknown
template <typename Arguments>
std::set<std::string> take(const char* function, const pybind11::kwargs& given, Arguments& arguments) {
  std::set<std::string> names;
  Arguments::describe_keywords(arguments, [&](const std::string& name, auto& value, const std::string&) {
    if (!given.contains(name)) return;
    names.insert(name);
    const pybind11::object object = given[name.c_str()];
    using Value = std::decay_t<decltype(value)>;
    try {
      value = pybind11::cast<Value>(object);
    } catch (const pybind11::cast_error&) {
      throw pybind11::type_error(fmt::format("{}: {} is not of a type that it takes; see help(rva.{})", name,
                                             std::string(pybind11::repr(object)), function));
    }
  });
  for (const auto& [key, value] : given) {
    const auto name = pybind11::cast<std::string>(key);
    if (!names.contains(name))
      throw pybind11::type_error(
          fmt::format("{}() has no argument {}; help(rva.{}) lists them", function, name, function));
  }
  return names;
}

/// A default as it is written in a signature.
template <typename Value>
std::string text_of_default(const Value& value) {
  if constexpr (std::is_base_of_v<pybind11::object, Value>)
    return std::string(pybind11::repr(value));
  else
    return std::string(pybind11::repr(pybind11::cast(value)));
}

/// The description of a function, which begins with its signature in the form that Python's inspect reads.
/// @param positional the arguments before the keywords, as in a signature
/// @param summary    what the function does
template <typename Arguments>
std::string description(const std::string& function, const std::string& positional,
                        const std::string& summary) {
  std::string signature = fmt::format("{}({}, *", function, positional);
  std::string lines;
  Arguments defaults;
  Arguments::describe_keywords(defaults,
                               [&](const std::string& name, auto& value, const std::string& sentence) {
                                 signature += fmt::format(", {}={}", name, text_of_default(value));
                                 lines += fmt::format("  {}: {}\n", name, sentence);
                               });
  return fmt::format("{})\n--\n\n{}\n\n{}", signature, summary, lines);
}

}  // namespace rva::python
