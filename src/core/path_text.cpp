#include "core/path_text.hpp"

#include <fmt/format.h>
#include <utf8.h>

#include <algorithm>
#include <cstddef>

#include "core/error.hpp"

namespace rva {
namespace {

bool is_control(char32_t character) { return character < 0x20 || (character >= 0x7F && character < 0xA0); }

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
