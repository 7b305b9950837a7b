#include "core/path_text.hpp"

#include <fmt/format.h>
#include <utf8.h>

#include <algorithm>
#include <cstddef>

#include "core/error.hpp"

namespace rva {
namespace {

// Marks and embeddings of the writing direction are controls as well: a terminal that obeys them shows the
// characters of a line in another order.
bool is_control(char32_t character) {
  const auto is_in = [character](char32_t from, char32_t to) { return character >= from && character <= to; };
  return is_in(0, 0x1F) || is_in(0x7F, 0x9F) || character == 0x61C || is_in(0x200E, 0x200F) ||
         is_in(0x202A, 0x202E) || is_in(0x2066, 0x2069);
}

std::string escaped(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) text += fmt::format("\\x{:02X}", static_cast<unsigned char>(byte));
  return text;
}

std::string without_controls(std::string_view utf8_text) {
  std::string text;
  for (auto at = utf8_text.begin(); at != utf8_text.end();) {
    const auto start = at;
    const char32_t character = utf8::unchecked::next(at);
    const std::string_view bytes(start, at);
    text += is_control(character) ? escaped(bytes) : std::string(bytes);
  }
  return text;
}

}  // namespace

bool is_utf8(std::string_view bytes) { return utf8::is_valid(bytes.begin(), bytes.end()); }

std::string printable(const std::filesystem::path& path) {
  std::string_view rest = path.native();
  if (rest.empty()) return "''";
  std::string text;
  while (!rest.empty()) {
    const auto invalid = utf8::find_invalid(rest.begin(), rest.end());
    const auto valid = static_cast<std::size_t>(invalid - rest.begin());
    text += without_controls(rest.substr(0, valid));
    text += escaped(rest.substr(valid, 1));
    rest.remove_prefix(std::min(valid + 1, rest.size()));
  }
  return text;
}

void require_utf8(const std::filesystem::path& path) {
  if (!is_utf8(path.native())) {
    throw Error(printable(path), "the path is not UTF-8 text", "rename it in UTF-8");
  }
}

}  // namespace rva
