#include "report/pdf/pdf_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <numeric>

namespace rva::pdf {
namespace {

constexpr double gap_pt = 3.0 * pt_per_mm;  // between columns
constexpr double padding_pt = 0.3 * pt_per_mm;
constexpr double rule_pt = 0.2 * pt_per_mm;
constexpr Ink rule_ink{0.8, 0.8, 0.8};
constexpr Ink head_ink{0.27, 0.27, 0.27};
constexpr Ink name_ink{0.33, 0.33, 0.33};

using Cells = std::vector<Content>;

Cells cells_of(const ReportPart& row) {
  Cells cells;
  for (const ReportPart& cell : row.inside.parts()) cells.push_back(cell.inside);
  return cells;
}

std::vector<double> natural_widths(const std::vector<Cells>& rows, const Setting& setting) {
  std::vector<double> widths;
  for (const Cells& cells : rows) {
    widths.resize(std::max(widths.size(), cells.size()), 0.0);
    for (std::size_t k = 0; k < cells.size(); ++k)
      widths[k] = std::max(widths[k], setting.text->width_pt(cells[k], setting.style));
  }
  return widths;
}

// Puts a cell beside those that a row has.
void add_cell(Box& row, const Content& content, double left_pt, const Setting& setting) {
  Box cell = stacked(boxes_of(content, setting));
  shift(cell, left_pt, padding_pt);
  row.height_pt = std::max(row.height_pt, cell.height_pt + 2.0 * padding_pt);
  std::ranges::move(cell.marks, std::back_inserter(row.marks));
}

Box row_box(const Cells& cells, const std::vector<double>& widths_pt, const Setting& setting) {
  Box row;
  double left_pt = 0.0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    add_cell(row, cells[k], left_pt, {setting.text, widths_pt[k], setting.style});
    left_pt += widths_pt[k] + gap_pt;
  }
  return row;
}

void add_rule(Box& row, double width_pt) {
  row.marks.push_back(rule(rule_ink, row.height_pt, width_pt, rule_pt));
  row.height_pt += rule_pt;
}

Setting styled(const Setting& setting, const Ink& ink, bool is_bold) {
  Setting styled = setting;
  styled.style.ink = ink;
  styled.style.is_bold = is_bold;
  return styled;
}

double room_for(std::size_t columns, double width_pt) {
  return width_pt - gap_pt * static_cast<double>(columns - 1);
}

}  // namespace

std::vector<double> column_widths(const std::vector<double>& natural_pt, double room_pt) {
  std::vector<std::size_t> narrowest_first(natural_pt.size());
  std::iota(narrowest_first.begin(), narrowest_first.end(), 0U);
  std::ranges::stable_sort(narrowest_first, {}, [&](std::size_t k) { return natural_pt[k]; });
  std::vector<double> widths_pt(natural_pt.size());
  double left_pt = room_pt;
  std::size_t columns = natural_pt.size();
  for (const std::size_t k : narrowest_first) {
    widths_pt[k] = std::min(natural_pt[k], left_pt / static_cast<double>(columns--));
    left_pt -= widths_pt[k];
  }
  if (!widths_pt.empty()) widths_pt.back() += left_pt;
  return widths_pt;
}

std::vector<Box> table_boxes(const Content& table, const Setting& setting) {
  const Setting head_setting = styled(setting, head_ink, true);
  const Cells head_cells = cells_of(table.parts().front().inside.parts().front());
  std::vector<Cells> rows;
  for (const ReportPart& row : table.parts().back().inside.parts()) rows.push_back(cells_of(row));
  std::vector<double> natural_pt = natural_widths(rows, setting);
  const std::vector<double> head_pt = natural_widths({head_cells}, head_setting);
  natural_pt.resize(head_pt.size(), 0.0);
  std::ranges::transform(natural_pt, head_pt, natural_pt.begin(),
                         [](double of_rows, double of_head) { return std::max(of_rows, of_head); });
  const std::vector<double> widths_pt =
      column_widths(natural_pt, room_for(natural_pt.size(), setting.width_pt));

  const auto head = std::make_shared<Box>(row_box(head_cells, widths_pt, head_setting));
  add_rule(*head, setting.width_pt);
  head->keeps_with_next = true;
  std::vector<Box> boxes{*head};
  for (const Cells& cells : rows) {
    boxes.push_back(row_box(cells, widths_pt, setting));
    add_rule(boxes.back(), setting.width_pt);
    boxes.back().head = head;
  }
  return boxes;
}

Box fields_box(const Content& fields, const Setting& setting) {
  constexpr std::array<double, 2> shares{1.0 / 3.0, 2.0 / 3.0};  // of the values in each column
  const std::vector<ReportPart>& parts = fields.parts();
  Setting name = styled(setting, name_ink, false);
  Setting value = styled(setting, setting.style.ink, true);
  name.width_pt = 0.0;
  for (std::size_t k = 0; k < parts.size(); k += 2)
    name.width_pt = std::max(name.width_pt, setting.text->width_pt(parts[k].inside, name.style));
  const double values_pt = setting.width_pt - 2.0 * name.width_pt - 3.0 * gap_pt;
  std::vector<Box> rows;
  double left_pt = 0.0;
  for (std::size_t k = 0; k + 1 < parts.size(); k += 2) {
    const std::size_t column = k / 2 % shares.size();
    if (column == 0) {
      rows.emplace_back();
      left_pt = 0.0;
    }
    value.width_pt = shares[column] * values_pt;
    add_cell(rows.back(), parts[k].inside, left_pt, name);
    add_cell(rows.back(), parts[k + 1].inside, left_pt + name.width_pt + gap_pt, value);
    left_pt += name.width_pt + value.width_pt + 2.0 * gap_pt;
  }
  return stacked(rows);
}

}  // namespace rva::pdf
