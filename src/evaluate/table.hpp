// Tables for people, which fit a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rva {

/// A column of a table.
struct TableColumn {
  std::string heading;               ///< above the cells
  std::vector<std::string> cells{};  ///< one for each row
};

/// Adds a row. @param cells one for each column
void add_row(std::vector<TableColumn>& columns, const std::vector<std::string>& cells);

/// The greatest width of a table, in characters.
inline constexpr std::size_t table_width = 100;

/// A table with a line of headings, each line ended by a line feed. Where the columns do not fit into
/// `table_width`, those that are left follow in further tables below, each with the keys first. Cells of more
/// than 28 characters are cut.
/// @param keys    columns that identify a row, aligned to the left
/// @param columns further columns, aligned to the right; of as many rows as the keys
[[nodiscard]] std::string table_of(const std::vector<TableColumn>& keys,
                                   const std::vector<TableColumn>& columns);

}  // namespace rva
