// JSON as Python's dictionaries and lists.
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <string>

#include "core/json_object.hpp"

namespace rva::python {

/// The value that JSON text describes.
[[nodiscard]] inline pybind11::object object_of(const std::string& text) {
  return pybind11::module_::import("json").attr("loads")(text);
}

/// The value as Python has it.
[[nodiscard]] inline pybind11::object object_of(const nlohmann::ordered_json& json) {
  return object_of(json_text(json));
}

}  // namespace rva::python
