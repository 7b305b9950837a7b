#include "core/event.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/json_object.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

bool is_plain(char c) {
  constexpr std::string_view marks = ".:/_+-";
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         marks.find(c) != std::string_view::npos;
}

std::string value_text(const std::string& value) {
  if (!value.empty() && std::ranges::all_of(value, is_plain)) return value;
  return json_text(nlohmann::json(value.empty() ? value : printable(value)));
}

}  // namespace

std::string event_text(const Event& event) {
  std::string line = fmt::format("{} event={}", printable(event.message), event.name);
  for (const auto& [name, value] : event.fields) line += fmt::format(" {}={}", name, value_text(value));
  return line;
}

std::string journal_prefix(EventLevel level) { return fmt::format("<{}>", static_cast<int>(level)); }

}  // namespace rva
