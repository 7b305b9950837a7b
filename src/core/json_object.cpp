#include "core/json_object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace rva {
namespace {

constexpr const char* mend = "correct the file";

Error not_a(const std::string& name, std::string_view kind) {
  return {name, fmt::format("not {}", kind), mend};
}

}  // namespace

nlohmann::json parse_json(const std::string& text, const std::string& source) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const auto line = 1 + std::count(text.begin(), end, '\n');
    throw Error(source, fmt::format("not JSON at line {}", line), mend);
  } catch (const nlohmann::json::out_of_range&) {
    throw Error(source, "contains a number that does not fit a double", mend);
  }
}

std::string json_text(const nlohmann::json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_text(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string json_file_text(const nlohmann::ordered_json& json, int indent) {
  return json_text(json, indent) + "\n";
}

JsonObject::JsonObject(const nlohmann::json& value, std::string source, std::string field)
    : value_(&value), source_(std::move(source)), field_(std::move(field)) {
  if (!value.is_object())
    throw not_a(field_.empty() ? source_ : fmt::format("{}: {}", source_, field_), "an object");
}

std::string JsonObject::name_of(std::string_view key) const {
  return field_.empty() ? fmt::format("{}: {}", source_, key)
                        : fmt::format("{}: {}.{}", source_, field_, key);
}

bool JsonObject::has(const char* key) const { return value_->contains(key) && !(*value_)[key].is_null(); }

std::vector<std::string> JsonObject::keys() const {
  std::vector<std::string> keys;
  for (const auto& item : value_->items()) keys.push_back(item.key());
  return keys;
}

const nlohmann::json& JsonObject::at(const char* key) const {
  if (!has(key)) throw Error(name_of(key), "missing", mend);
  return (*value_)[key];
}

double JsonObject::number(const char* key) const {
  const auto& value = at(key);
  if (!value.is_number()) throw not_a(name_of(key), "a number");
  return value.get<double>();
}

int JsonObject::integer(const char* key) const {
  const double value = number(key);
  const int whole = value > -2e9 && value < 2e9 ? static_cast<int>(value) : 0;
  if (static_cast<double>(whole) != value) throw not_a(name_of(key), "a whole number in the possible range");
  return whole;
}

bool JsonObject::boolean(const char* key) const {
  const auto& value = at(key);
  if (!value.is_boolean()) throw not_a(name_of(key), "true or false");
  return value.get<bool>();
}

std::string JsonObject::string(const char* key) const {
  const auto& value = at(key);
  if (!value.is_string()) throw not_a(name_of(key), "a string");
  return value.get<std::string>();
}

JsonObject JsonObject::object(const char* key) const {
  return {at(key), source_, field_.empty() ? std::string(key) : fmt::format("{}.{}", field_, key)};
}

std::vector<double> JsonObject::numbers(const char* key, std::size_t count) const {
  const auto& value = at(key);
  const bool fits =
      value.is_array() && value.size() == count &&
      std::all_of(value.begin(), value.end(), [](const auto& item) { return item.is_number(); });
  if (!fits) throw not_a(name_of(key), fmt::format("a list of {} numbers", count));
  return value.get<std::vector<double>>();
}

std::optional<double> JsonObject::optional_number(const char* key) const {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}

std::optional<std::string> JsonObject::optional_string(const char* key) const {
  return has(key) ? std::optional(string(key)) : std::nullopt;
}

std::optional<JsonObject> JsonObject::optional_object(const char* key) const {
  return has(key) ? std::optional(object(key)) : std::nullopt;
}

}  // namespace rva
