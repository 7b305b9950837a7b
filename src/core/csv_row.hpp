// Comma-separated values for spreadsheets.
#pragma once

#include <string>
#include <vector>

namespace rva {

/// A row as RFC 4180 has it: a cell with a comma, a quote or a line break is quoted, a quote in it is
/// doubled, and the row ends with CR LF. A cell that a spreadsheet would take for a formula begins with an
/// apostrophe.
[[nodiscard]] std::string csv_row(const std::vector<std::string>& cells);

}  // namespace rva
