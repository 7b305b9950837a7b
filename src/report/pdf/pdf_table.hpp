// Tables.
#pragma once

#include <vector>

#include "report/pdf/pdf_blocks.hpp"

namespace rva::pdf {

/// The rows of a table as boxes. A page that begins with a row repeats the head.
/// @param table its head and its body
[[nodiscard]] std::vector<Box> table_boxes(const Content& table, const Setting& setting);

/// Names and values, two of each in a row.
[[nodiscard]] Box fields_box(const Content& fields, const Setting& setting);

/// The widths of columns that together have `room_pt`: as wide as their contents where there is room, with
/// what is left for the last one; otherwise the widest ones share what the others leave.
[[nodiscard]] std::vector<double> column_widths(const std::vector<double>& natural_pt, double room_pt);

}  // namespace rva::pdf
