#include "evaluate/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <optional>
#include <span>

namespace rva {
namespace {

constexpr std::size_t widest_cell = 28;
constexpr std::size_t gap = 2;

std::size_t width_of(const TableColumn& column) {
  std::size_t width = column.heading.size();
  for (const std::string& cell : column.cells) width = std::max(width, cell.size());
  return std::min(width, widest_cell);
}

std::size_t width_of(std::span<const TableColumn> columns) {
  std::size_t width = 0;
  for (const TableColumn& column : columns) width += width_of(column) + gap;
  return width;
}

/// One line of a table: the headings, or a row.
class Line {
 public:
  explicit Line(std::optional<std::size_t> row) : row_(row) {}

  void add_left(const TableColumn& column) {
    fmt::format_to(std::back_inserter(text_), "{:{}.{}}", text_of(column), width_of(column) + gap,
                   widest_cell);
  }
  void add_right(const TableColumn& column) {
    fmt::format_to(std::back_inserter(text_), "{:>{}.{}}{:{}}", text_of(column), width_of(column),
                   widest_cell, "", gap);
  }
  [[nodiscard]] std::string text() const { return text_.substr(0, text_.find_last_not_of(' ') + 1) + "\n"; }

 private:
  [[nodiscard]] const std::string& text_of(const TableColumn& column) const {
    return row_ ? column.cells[*row_] : column.heading;
  }

  std::optional<std::size_t> row_;
  std::string text_;
};

std::string one_table(std::span<const TableColumn> keys, std::span<const TableColumn> columns) {
  std::string table;
  const auto add = [&](std::optional<std::size_t> row) {
    Line line(row);
    for (const TableColumn& key : keys) line.add_left(key);
    for (const TableColumn& column : columns) line.add_right(column);
    table += line.text();
  };
  add(std::nullopt);
  for (std::size_t row = 0; row < keys.front().cells.size(); ++row) add(row);
  return table;
}

}  // namespace

void add_row(std::vector<TableColumn>& columns, const std::vector<std::string>& cells) {
  assert(cells.size() == columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k) columns[k].cells.push_back(cells[k]);
}

std::string table_of(const std::vector<TableColumn>& keys, const std::vector<TableColumn>& columns) {
  std::string text;
  std::span<const TableColumn> left(columns);
  while (!left.empty()) {
    std::size_t count = 1;
    while (count < left.size() && width_of(keys) + width_of(left.first(count + 1)) - gap <= table_width)
      ++count;
    if (!text.empty()) text += "\n";
    text += one_table(keys, left.first(count));
    left = left.subspan(count);
  }
  return text;
}

}  // namespace rva
