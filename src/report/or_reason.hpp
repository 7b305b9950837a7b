// What a report contains where a file of the inspection cannot be read.
#pragma once

#include <concepts>
#include <cstddef>
#include <string_view>

#include "core/error.hpp"
#include "report/html.hpp"

namespace rva {

/// What `make` returns or, if it throws an Error, the reason in its place: a report on a damaged record
/// states what is missing rather than that there is none.
template <std::invocable Make>
[[nodiscard]] Html or_reason(const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    return Html::element("p", Html::text("Cannot be shown: ") + Html::typed(error.what()), "missing");
  }
}

/// How many such reasons a piece of markup contains.
[[nodiscard]] inline std::size_t count_reasons(const Html& html) {
  constexpr std::string_view mark = "<p class=\"missing\">";
  std::size_t count = 0;
  for (std::size_t at = html.str().find(mark); at != std::string::npos; at = html.str().find(mark, at + 1))
    ++count;
  return count;
}

}  // namespace rva
