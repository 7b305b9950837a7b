// The parts of a report as boxes.
#pragma once

#include <vector>

#include "report/pdf/pdf_box.hpp"
#include "report/pdf/pdf_text.hpp"
#include "report/report_content.hpp"

namespace rva::pdf {

/// Where and how parts are set.
struct Setting {
  const TextSetter* text = nullptr;
  double width_pt = 0.0;
  TextStyle style{};  ///< of parts that have none of their own
};

/// The boxes of parts, one below another. Parts within a line that follow each other are one paragraph.
[[nodiscard]] std::vector<Box> boxes_of(const Content& content, const Setting& setting);

}  // namespace rva::pdf
