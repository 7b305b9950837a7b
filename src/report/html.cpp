#include "report/html.hpp"

#include <fmt/format.h>
#include <utf8.h>

#include <iterator>

#include "audit/digest.hpp"

namespace rva {
namespace {

constexpr char32_t replacement = 0xFFFD;

// Control characters other than tab and line feed, and what is no character at all, are errors in a document.
bool is_allowed(char32_t character) {
  constexpr char32_t delete_character = 0x7F;
  constexpr char32_t end_of_controls = 0xA0;
  constexpr char32_t no_characters = 0xFFFE;
  if (character == '\t' || character == '\n') return true;
  if (character < ' ' || (character >= delete_character && character < end_of_controls)) return false;
  return (character & no_characters) != no_characters && (character < 0xFDD0 || character > 0xFDEF);
}

void append(char32_t character, std::string& markup) {
  switch (character) {
    case '&':
      markup += "&amp;";
      return;
    case '<':
      markup += "&lt;";
      return;
    case '>':
      markup += "&gt;";
      return;
    case '"':
      markup += "&quot;";
      return;
    case '\'':
      markup += "&#39;";
      return;
    default:
      utf8::append(is_allowed(character) ? character : replacement, std::back_inserter(markup));
  }
}

std::string escaped(std::string_view words) {
  std::string well_formed;
  utf8::replace_invalid(words.begin(), words.end(), std::back_inserter(well_formed), replacement);
  std::string markup;
  for (auto at = well_formed.begin(); at != well_formed.end();)
    append(static_cast<char32_t>(utf8::next(at, well_formed.end())), markup);
  return markup;
}

Html row_of(const std::vector<Html>& cells, std::string_view first, std::string_view other) {
  Html row;
  for (const Html& cell : cells) row += Html::element(row.empty() ? first : other, cell);
  return Html::element("tr", row);
}

}  // namespace

Html Html::text(std::string_view words) { return markup(escaped(words)); }

Html Html::typed(std::string_view words) { return element("bdi", text(words), "typed"); }

Html Html::element(std::string_view name, const Html& content, std::string_view class_name) {
  const std::string attribute = class_name.empty() ? "" : fmt::format(" class=\"{}\"", class_name);
  return markup(fmt::format("<{0}{1}>{2}</{0}>", name, attribute, content.markup_));
}

Html Html::jpeg(std::span<const std::byte> jpeg, std::string_view description) {
  const std::string_view bytes(reinterpret_cast<const char*>(jpeg.data()), jpeg.size());
  return markup(fmt::format("<img alt=\"{}\" src=\"data:image/jpeg;base64,{}\">", escaped(description),
                            base64_of(bytes)));
}

Html Html::markup(std::string_view written) {
  Html html;
  html.markup_ = written;
  return html;
}

Html& Html::operator+=(const Html& more) {
  markup_ += more.markup_;
  return *this;
}

Html html_of(const HtmlTable& table) {
  Html content;
  if (!table.head.empty()) content += Html::element("thead", row_of(table.head, "th", "th"));
  Html body;
  for (const std::vector<Html>& row : table.rows) body += row_of(row, table.head.empty() ? "th" : "td", "td");
  return Html::element("table", content + Html::element("tbody", body), table.class_name);
}

}  // namespace rva
