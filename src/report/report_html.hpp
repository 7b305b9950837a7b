// The HTML of a report's contents.
#pragma once

#include "report/html.hpp"
#include "report/report_content.hpp"

namespace rva {

/// The elements of all parts, in their order; `report_style` is made for their classes.
[[nodiscard]] Html html_of(const Content& content);

}  // namespace rva
