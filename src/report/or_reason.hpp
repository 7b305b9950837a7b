// What a report contains where a file of the inspection cannot be read.
#pragma once

#include <concepts>

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

}  // namespace rva
