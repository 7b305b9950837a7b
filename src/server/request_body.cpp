#include "server/request_body.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "server/api.hpp"

namespace rva {
namespace {

ApiError bad(const std::string& source, const std::string& problem) {
  return {400, "bad-request", source, problem, "see docs/api.md"};
}

bool is_control(char character) {
  const auto byte = static_cast<unsigned char>(character);
  return (byte < 0x20 && character != '\n' && character != '\t') || byte == 0x7F;
}

}  // namespace

Json parse_body(const std::string& text) {
  constexpr int deepest = 8;
  if (text.empty()) return Json::object();
  const Json::parser_callback_t shallow = [](int depth, Json::parse_event_t /*event*/, Json& /*parsed*/) {
    if (depth > deepest) throw bad("request", "is nested too deeply");
    return true;
  };
  Json body;
  try {
    body = Json::parse(text, shallow);
  } catch (const Json::exception&) {
    throw bad("request", "is not JSON");
  }
  if (!body.is_object()) throw bad("request", "is not a JSON object");
  return body;
}

std::string text_field(const Json& body, const char* key, std::size_t most_bytes) {
  const auto found = body.find(key);
  if (found == body.end() || found->is_null()) return {};
  if (!found->is_string()) throw bad(key, "is not a text");
  auto text = found->get<std::string>();
  if (text.size() > most_bytes) throw bad(key, "is too long");
  if (std::ranges::any_of(text, is_control)) throw bad(key, "has control characters");
  return text;
}

bool flag_field(const Json& body, const char* key) {
  const auto found = body.find(key);
  if (found == body.end() || found->is_null()) return false;
  if (!found->is_boolean()) throw bad(key, "is neither true nor false");
  return found->get<bool>();
}

double number_field(const Json& body, const char* key) {
  const auto found = body.find(key);
  if (found == body.end() || !found->is_number()) throw bad(key, "is not a number");
  const auto number = found->get<double>();
  if (!std::isfinite(number)) throw bad(key, "is not a number");
  return number;
}

int count_field(const Json& body, const char* key) {
  constexpr double most_number = 1e9;
  const double number = number_field(body, key);
  return number >= 0.0 && number <= most_number && number == std::floor(number) ? static_cast<int>(number)
                                                                                : -1;
}

Box box_field(const Json& body, const char* key) {
  constexpr double most_number = 1e9;
  const auto found = body.find(key);
  std::array<int, 4> sides{};
  const bool is_list = found != body.end() && found->is_array() && found->size() == sides.size();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double side = is_list && (*found)[i].is_number() ? (*found)[i].get<double>() : -1.0;
    if (!(side >= 0.0 && side <= most_number)) throw bad(key, "is not a list of four numbers from 0");
    sides[i] = static_cast<int>(side);
  }
  return {sides[0], sides[1], sides[2], sides[3]};
}

std::optional<int> number_in_path(const std::string& text) {
  int number = -1;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = failure == std::errc{} && end == text.data() + text.size() && number >= 0;
  return whole ? std::optional(number) : std::nullopt;
}

}  // namespace rva
