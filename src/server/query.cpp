#include "server/query.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "server/api.hpp"
#include "server/request_body.hpp"

namespace rva {
namespace {

ApiError malformed(const std::string& problem) {
  return {400, "bad-request", "address", problem, "see docs/api.md"};
}

char escaped(std::string_view digits) {
  unsigned value = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.size() != 2 || failure != std::errc{} || end != digits.data() + digits.size())
    throw malformed("contains a malformed % escape");
  return static_cast<char>(value);
}

std::string decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%') {
      plain += escaped(text.substr(i + 1, 2));
      i += 2;
    } else {
      plain += text[i] == '+' ? ' ' : text[i];
    }
  }
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  if (plain.size() > most_field_bytes || std::ranges::any_of(plain, is_control))
    throw malformed("contains a text that is too long, or control characters");
  return plain;
}

}  // namespace

QueryValues query_values(std::string_view query) {
  QueryValues values;
  std::istringstream pairs{std::string(query)};
  for (std::string pair; std::getline(pairs, pair, '&');) {
    const std::size_t equals = std::min(pair.find('='), pair.size());
    const std::string_view all = pair;
    if (!pair.empty())
      values[decoded(all.substr(0, equals))] = decoded(all.substr(std::min(equals + 1, pair.size())));
  }
  return values;
}

}  // namespace rva
