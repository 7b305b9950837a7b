#include "report/pdf/pdf_blocks.hpp"

#include <algorithm>
#include <iterator>

#include "report/pdf/pdf_picture.hpp"
#include "report/pdf/pdf_table.hpp"

namespace rva::pdf {
namespace {

constexpr Ink red{0.70, 0.07, 0.11};
constexpr Ink green{0.11, 0.48, 0.20};
constexpr Ink amber{0.66, 0.39, 0.0};
constexpr Ink grey{0.27, 0.27, 0.27};
constexpr Ink light_grey{0.73, 0.73, 0.73};
constexpr double small_pt = 7.5;
constexpr double between_pt = 0.5 * pt_per_mm;  // paragraphs

/// Appearance of a role that is lines of text.
struct LineStyle {
  TextStyle text{};
  double above_pt = between_pt;
  bool keeps_with_next = false;
};

LineStyle line_style(PartRole role, const TextStyle& around) {
  LineStyle style{.text = around};
  const auto sized = [&](double size_pt, bool is_bold, const Ink& ink) {
    style.text = {.size_pt = size_pt, .ink = ink, .is_bold = is_bold, .is_italic = false};
  };
  switch (role) {
    case PartRole::title:
      sized(15.0, true, around.ink);
      break;
    case PartRole::heading:
      sized(11.0, true, around.ink);
      style.above_pt = 3.0 * pt_per_mm;
      style.keeps_with_next = true;
      break;
    case PartRole::finding_title:
      sized(10.0, true, around.ink);
      style.keeps_with_next = true;
      break;
    case PartRole::sentence:
      sized(13.0, true, around.ink);
      break;
    case PartRole::caption:
      sized(8.0, false, grey);
      break;
    case PartRole::legend:
    case PartRole::warning:
    case PartRole::foot:
      sized(small_pt, false, grey);
      break;
    case PartRole::missing:
      style.text.ink = red;
      break;
    case PartRole::open_decision:
      style.text.ink = red;
      style.text.is_bold = true;
      break;
    case PartRole::note:
      style.text.is_italic = true;
      break;
    default:
      break;
  }
  return style;
}

// The border of the verdict or of a finding. Its width is zero for all other roles.
Border border_of(PartRole role, double width_pt) {
  const auto verdict = [&](const Ink& ink) {
    return Border{ink, 3.0 * pt_per_mm, 0.5 * pt_per_mm, width_pt};
  };
  switch (role) {
    case PartRole::verdict_clear:
      return verdict(green);
    case PartRole::verdict_bad:
      return verdict(red);
    case PartRole::verdict_warning:
      return verdict(amber);
    case PartRole::verdict_open:
      return verdict(grey);
    case PartRole::finding:
      return {light_grey, 0.8 * pt_per_mm, 0.0, width_pt};
    default:
      return {};
  }
}

Box bordered(const ReportPart& part, const Border& border, const Setting& setting) {
  const double left_pt = border.left_pt + 3.5 * pt_per_mm;
  const double right_pt = border.around_pt > 0.0 ? 4.0 * pt_per_mm : 0.0;
  const double vertical_pt = border.around_pt > 0.0 ? 2.0 * pt_per_mm : 1.0 * pt_per_mm;
  Setting inner = setting;
  inner.width_pt -= left_pt + right_pt;
  Box box = stacked(boxes_of(part.inside, inner));
  shift(box, left_pt, vertical_pt);
  box.height_pt += 2.0 * vertical_pt;
  box.border = border;
  box.above_pt = 2.0 * pt_per_mm;
  return box;
}

void add_rule(Box& box, double y_pt, double width_pt) {
  constexpr double rule_pt = 0.3 * pt_per_mm;
  constexpr Ink ink{0.6, 0.6, 0.6};
  box.marks.push_back(rule(ink, y_pt, width_pt, rule_pt));
  box.height_pt = std::max(box.height_pt, y_pt + rule_pt);
}

// A bar beside each line, so that a long note can be divided between them.
Box note_box(const ReportPart& part, const Setting& setting) {
  constexpr double indent_pt = 3.0 * pt_per_mm;
  constexpr double bar_pt = 0.6 * pt_per_mm;
  Box box = setting.text->lines(part.inside, line_style(part.role, setting.style).text,
                                setting.width_pt - indent_pt);
  shift(box, indent_pt, 0.0);
  const std::size_t lines = box.marks.size();
  for (std::size_t k = 0; k < lines; ++k)
    box.marks.push_back(rule(light_grey, box.marks[k].y_pt, bar_pt, box.marks[k].height_pt));
  box.above_pt = 1.0 * pt_per_mm;
  return box;
}

Box lines_box(const ReportPart& part, const Setting& setting) {
  if (part.role == PartRole::note) return note_box(part, setting);
  const LineStyle style = line_style(part.role, setting.style);
  const Content bullet = part.role == PartRole::warning ? Content::text("• ") : Content();
  Box box = setting.text->lines(bullet + part.inside, style.text, setting.width_pt);
  box.above_pt = style.above_pt;
  box.keeps_with_next = style.keeps_with_next;
  if (part.role == PartRole::heading) add_rule(box, box.height_pt, setting.width_pt);
  if (part.role == PartRole::foot) {
    constexpr double below_rule_pt = 1.0 * pt_per_mm;
    shift(box, 0.0, below_rule_pt);
    box.height_pt += below_rule_pt;
    box.above_pt = 2.0 * pt_per_mm;
    add_rule(box, 0.0, setting.width_pt);
  }
  return box;
}

Setting sized(const Setting& setting, double size_pt) {
  Setting smaller = setting;
  smaller.style.size_pt = size_pt;
  return smaller;
}

std::vector<Box> group_boxes(const ReportPart& part, const Setting& setting) {
  constexpr double table_pt = 8.0;
  switch (part.role) {
    case PartRole::picture:
      return {picture_box(part.picture, setting.width_pt)};
    case PartRole::two_figures:
      return figure_rows(part.inside, 2, setting);
    case PartRole::three_figures:
      return figure_rows(part.inside, 3, setting);
    case PartRole::close_ups:
      return figure_rows(part.inside, 4, setting);
    case PartRole::table:
    case PartRole::coverage_table:
    case PartRole::events_table:
    case PartRole::checksum_table:
      return table_boxes(part.inside, sized(setting, std::min(table_pt, setting.style.size_pt)));
    case PartRole::fields:
      return {fields_box(part.inside, setting)};
    case PartRole::settings: {
      Setting small = sized(setting, small_pt);
      small.style.ink = grey;
      return boxes_of(part.inside, small);
    }
    default:
      return boxes_of(part.inside, setting);
  }
}

bool is_lines(PartRole role) {
  switch (role) {
    case PartRole::title:
    case PartRole::heading:
    case PartRole::finding_title:
    case PartRole::sentence:
    case PartRole::paragraph:
    case PartRole::missing:
    case PartRole::decision:
    case PartRole::open_decision:
    case PartRole::legend:
    case PartRole::caption:
    case PartRole::note:
    case PartRole::warning:
    case PartRole::foot:
      return true;
    default:
      return false;
  }
}

std::vector<Box> part_boxes(const ReportPart& part, const Setting& setting) {
  const Border border = border_of(part.role, setting.width_pt);
  if (border.left_pt > 0.0) return {bordered(part, border, setting)};
  if (is_lines(part.role)) return {lines_box(part, setting)};
  return group_boxes(part, setting);
}

}  // namespace

std::vector<Box> boxes_of(const Content& content, const Setting& setting) {
  std::vector<Box> boxes;
  Content line;
  const auto end_line = [&] {
    if (!line.empty()) boxes.push_back(setting.text->lines(line, setting.style, setting.width_pt));
    line = {};
  };
  for (const ReportPart& part : content.parts()) {
    if (is_inline(part.role)) {
      line.append(part);
      continue;
    }
    end_line();
    // A heading that is followed by another one, such as that of a round without findings, is complete.
    if (part.role == PartRole::heading && !boxes.empty()) boxes.back().keeps_with_next = false;
    std::ranges::move(part_boxes(part, setting), std::back_inserter(boxes));
  }
  end_line();
  return boxes;
}

}  // namespace rva::pdf
