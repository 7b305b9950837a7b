#include "report/report_content.hpp"

#include <utf8.h>

#include <iterator>
#include <utility>

#include "depth/image_file.hpp"

namespace rva {
namespace {

constexpr int quality = 85;
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

Content row_of(const std::vector<Content>& cells, PartRole role) {
  Content row;
  for (const Content& cell : cells) row += Content::of(role, cell);
  return Content::of(PartRole::row, row);
}

}  // namespace

std::string words_of(const Content& content) {
  std::string words;
  for (const ReportPart& part : content.parts()) words += part.words + words_of(part.inside);
  return words;
}

Content Content::text(std::string_view words) {
  Content content;
  content.append({.role = PartRole::text, .words = shown_text(words), .picture = {}, .inside = {}});
  return content;
}

Content Content::typed(std::string_view words) {
  Content content;
  content.append({.role = PartRole::typed, .words = shown_text(words), .picture = {}, .inside = {}});
  return content;
}

Content Content::picture(const ColorImage& picture, std::string_view description) {
  Content content;
  content.append({.role = PartRole::picture,
                  .words = shown_text(description),
                  .picture = {encode_jpeg(picture, quality), picture.width(), picture.height()},
                  .inside = {}});
  return content;
}

Content Content::of(PartRole role, Content inside) {
  Content content;
  content.append({.role = role, .words = {}, .picture = {}, .inside = std::move(inside)});
  return content;
}

void Content::append(ReportPart part) { parts_.push_back(std::move(part)); }

Content& Content::operator+=(const Content& more) {
  parts_.insert(parts_.end(), more.parts_.begin(), more.parts_.end());
  return *this;
}

Content content_of(const ReportTable& table) {
  Content body;
  for (const std::vector<Content>& row : table.rows) body += row_of(row, PartRole::cell);
  return Content::of(table.role, Content::of(PartRole::table_head, row_of(table.head, PartRole::head_cell)) +
                                     Content::of(PartRole::table_body, body));
}

std::size_t count_of(PartRole role, const Content& content) {
  std::size_t count = 0;
  for (const ReportPart& part : content.parts())
    count += (part.role == role ? 1U : 0U) + count_of(role, part.inside);
  return count;
}

std::string shown_text(std::string_view words) {
  std::string well_formed;
  utf8::replace_invalid(words.begin(), words.end(), std::back_inserter(well_formed), replacement);
  std::string shown;
  for (auto at = well_formed.begin(); at != well_formed.end();) {
    const auto character = static_cast<char32_t>(utf8::next(at, well_formed.end()));
    utf8::append(is_allowed(character) ? character : replacement, std::back_inserter(shown));
  }
  return shown;
}

}  // namespace rva
