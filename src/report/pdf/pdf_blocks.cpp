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

/// The rim of a group: its border, and the distances to what is within.
struct Rim {
  Border border{};
  double left_pt = 0.0;
  double vertical_pt = 0.0;
};

Rim rim_of(PartRole role) {
  const auto verdict = [](const Ink& ink) {
    return Rim{{ink, 3.0 * pt_per_mm, 0.5 * pt_per_mm, 0.0}, 7.0 * pt_per_mm, 2.0 * pt_per_mm};
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
    case PartRole::note:
      return {{light_grey, 0.6 * pt_per_mm, 0.0, 0.0}, 3.0 * pt_per_mm, 0.0};
    default:
      return {{light_grey, 0.8 * pt_per_mm, 0.0, 0.0}, 3.8 * pt_per_mm, 1.0 * pt_per_mm};
  }
}

bool has_rim(PartRole role) {
  switch (role) {
    case PartRole::verdict_clear:
    case PartRole::verdict_bad:
    case PartRole::verdict_warning:
    case PartRole::verdict_open:
    case PartRole::note:
    case PartRole::finding:
      return true;
    default:
      return false;
  }
}

Box rimmed(const ReportPart& part, const Setting& setting) {
  const Rim rim = rim_of(part.role);
  Setting inner = setting;
  inner.style = line_style(part.role, setting.style).text;
  const double right_pt = rim.border.around_pt > 0.0 ? 4.0 * pt_per_mm : 0.0;
  inner.width_pt -= rim.left_pt + right_pt;
  Box box = stacked(boxes_of(part.inside, inner));
  shift(box, rim.left_pt, rim.vertical_pt);
  box.height_pt += 2.0 * rim.vertical_pt;
  box.border = rim.border;
  box.border.width_pt = setting.width_pt;
  box.above_pt = 2.0 * pt_per_mm;
  return box;
}

void add_rule(Box& box, double y_pt, double width_pt) {
  constexpr double rule_pt = 0.3 * pt_per_mm;
  constexpr Ink ink{0.6, 0.6, 0.6};
  box.marks.push_back(rule(ink, y_pt, width_pt, rule_pt));
  box.height_pt = std::max(box.height_pt, y_pt + rule_pt);
}

Box lines_box(const ReportPart& part, const Setting& setting) {
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
    case PartRole::warning:
    case PartRole::foot:
      return true;
    default:
      return false;
  }
}

std::vector<Box> part_boxes(const ReportPart& part, const Setting& setting) {
  if (has_rim(part.role)) return {rimmed(part, setting)};
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
    std::ranges::move(part_boxes(part, setting), std::back_inserter(boxes));
  }
  end_line();
  return boxes;
}

}  // namespace rva::pdf
