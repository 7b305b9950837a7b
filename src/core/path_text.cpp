#include "core/path_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/error.hpp"

namespace rva {
namespace {

struct Range {
  std::uint8_t low;
  std::uint8_t high;
  [[nodiscard]] bool holds(std::uint8_t byte) const { return byte >= low && byte <= high; }
};

constexpr Range continuation{0x80, 0xBF};

// One form of well-formed sequence: its first byte, its second byte and its length. Bytes after the second
// are continuation bytes (The Unicode Standard 15, table 3-7).
struct SequenceForm {
  Range lead;
  Range second;
  std::size_t length;
};

constexpr std::array<SequenceForm, 9> sequence_forms{{{{0x00, 0x7F}, {0x00, 0xFF}, 1},
                                                      {{0xC2, 0xDF}, continuation, 2},
                                                      {{0xE0, 0xE0}, {0xA0, 0xBF}, 3},
                                                      {{0xE1, 0xEC}, continuation, 3},
                                                      {{0xED, 0xED}, {0x80, 0x9F}, 3},
                                                      {{0xEE, 0xEF}, continuation, 3},
                                                      {{0xF0, 0xF0}, {0x90, 0xBF}, 4},
                                                      {{0xF1, 0xF3}, continuation, 4},
                                                      {{0xF4, 0xF4}, {0x80, 0x8F}, 4}}};

bool starts_with(std::string_view bytes, const SequenceForm& form) {
  if (bytes.size() < form.length || !form.lead.holds(static_cast<std::uint8_t>(bytes[0]))) return false;
  for (std::size_t k = 1; k < form.length; ++k) {
    const Range& allowed = k == 1 ? form.second : continuation;
    if (!allowed.holds(static_cast<std::uint8_t>(bytes[k]))) return false;
  }
  return true;
}

// Length of the well-formed sequence that starts at `at`, 0 where there is none.
std::size_t sequence_length(std::string_view bytes, std::size_t at) {
  for (const SequenceForm& form : sequence_forms) {
    if (starts_with(bytes.substr(at), form)) return form.length;
  }
  return 0;
}

bool is_control(std::string_view bytes, std::size_t at) {
  const auto byte = static_cast<std::uint8_t>(bytes[at]);
  if (byte == 0xC2) return static_cast<std::uint8_t>(bytes[at + 1]) < 0xA0;
  return byte < 0x20 || byte == 0x7F;
}

}  // namespace

bool is_utf8(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = sequence_length(bytes, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

std::string printable(const std::filesystem::path& path) {
  const std::string& bytes = path.native();
  if (bytes.empty()) return "''";
  std::string text;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = sequence_length(bytes, at);
    if (length == 0 || is_control(bytes, at)) {
      text += fmt::format("\\x{:02X}", static_cast<std::uint8_t>(bytes[at]));
      at += 1;
    } else {
      text.append(bytes, at, length);
      at += length;
    }
  }
  return text;
}

void require_utf8(const std::filesystem::path& path) {
  if (!is_utf8(path.native())) {
    throw Error(printable(path), "the path is not UTF-8 text", "rename it in UTF-8");
  }
}

}  // namespace rva
