// What a loader may do with any bytes: give a value or refuse them with a sentence for a person.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {

/// assert() that stays in optimised builds.
inline void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", what.c_str());
  std::abort();
}

/// True where a terminal could be led astray: the controls of ASCII and, as UTF-8, those of Latin-1.
inline bool holds_control(std::string_view utf8) {
  std::uint8_t before = 0;
  return std::ranges::any_of(utf8, [&](char character) {
    const auto byte = static_cast<std::uint8_t>(character);
    const bool control = byte < 0x20 || byte == 0x7F || (before == 0xC2 && byte < 0xA0);
    before = byte;
    return control;
  });
}

/// The result of `load`, empty where it threw an Error. Whatever else it throws ends the fuzzer.
template <typename Load>
auto load_or_refuse(Load load) -> std::optional<decltype(load())> {
  try {
    return load();
  } catch (const Error& error) {
    const std::string_view what = error.what();
    require(is_utf8(what), "an Error's text is UTF-8");
    require(!holds_control(what), "an Error's text is one line without control characters");
    return std::nullopt;
  }
}

}  // namespace rva
