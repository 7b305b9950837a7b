#include "report/report_html.hpp"

#include <string_view>

namespace rva {
namespace {

struct Element {
  std::string_view name;
  std::string_view class_name{};
};

Element line_element(PartRole role) {
  switch (role) {
    case PartRole::strong:
      return {"strong"};
    case PartRole::code:
      return {"code"};
    case PartRole::title:
      return {"h1"};
    case PartRole::heading:
      return {"h2"};
    case PartRole::finding_title:
      return {"h3"};
    case PartRole::sentence:
      return {"p", "sentence"};
    case PartRole::missing:
      return {"p", "missing"};
    case PartRole::decision:
      return {"p", "decision"};
    case PartRole::open_decision:
      return {"p", "decision open"};
    case PartRole::legend:
      return {"p", "legend"};
    case PartRole::caption:
      return {"figcaption"};
    case PartRole::note:
      return {"blockquote"};
    case PartRole::warning:
      return {"li"};
    case PartRole::field_name:
      return {"dt"};
    case PartRole::field_value:
      return {"dd"};
    case PartRole::foot:
      return {"footer"};
    default:
      return {"p"};
  }
}

Element element_of(PartRole role) {
  switch (role) {
    case PartRole::head:
      return {"header"};
    case PartRole::fields:
      return {"dl"};
    case PartRole::verdict_clear:
      return {"section", "verdict clear"};
    case PartRole::verdict_bad:
      return {"section", "verdict bad"};
    case PartRole::verdict_warning:
      return {"section", "verdict warn"};
    case PartRole::verdict_open:
      return {"section", "verdict open"};
    case PartRole::warnings:
      return {"ul", "warnings"};
    case PartRole::settings:
      return {"div", "settings"};
    case PartRole::finding:
      return {"section", "finding"};
    case PartRole::figure:
      return {"figure"};
    case PartRole::two_figures:
      return {"div", "pictures two"};
    case PartRole::three_figures:
      return {"div", "pictures three"};
    case PartRole::close_ups:
      return {"div", "crops"};
    case PartRole::table:
      return {"table"};
    case PartRole::coverage_table:
      return {"table", "coverage"};
    case PartRole::events_table:
      return {"table", "events"};
    case PartRole::checksum_table:
      return {"table", "checksums"};
    case PartRole::table_head:
      return {"thead"};
    case PartRole::table_body:
      return {"tbody"};
    case PartRole::row:
      return {"tr"};
    case PartRole::head_cell:
      return {"th"};
    case PartRole::cell:
      return {"td"};
    default:
      return line_element(role);
  }
}

Html html_of_part(const ReportPart& part) {
  switch (part.role) {
    case PartRole::text:
      return Html::text(part.words);
    case PartRole::typed:
      return Html::typed(part.words);
    case PartRole::picture:
      return Html::jpeg(part.picture.jpeg, part.words);
    default:
      break;
  }
  const Element element = element_of(part.role);
  return Html::element(element.name, html_of(part.inside), element.class_name);
}

}  // namespace

Html html_of(const Content& content) {
  Html html;
  for (const ReportPart& part : content.parts()) html += html_of_part(part);
  return html;
}

}  // namespace rva
