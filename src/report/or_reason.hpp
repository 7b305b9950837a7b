// What a report contains where a file of the inspection cannot be read.
#pragma once

#include <concepts>

#include "core/error.hpp"
#include "report/report_content.hpp"

namespace rva {

/// What `make` returns or, if it throws an Error, the reason in its place: a report on a damaged record
/// states what is missing rather than that there is none.
template <std::invocable Make>
[[nodiscard]] Content or_reason(const Make& make) {
  try {
    return make();
  } catch (const Error& error) {
    return Content::of(PartRole::missing, Content::text("Cannot be shown: ") + Content::typed(error.what()));
  }
}

}  // namespace rva
