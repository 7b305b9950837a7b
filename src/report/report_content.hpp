// What a report contains, apart from its appearance: HTML and PDF are made of the same parts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// What a part of a report is. Each rendering gives it its appearance.
enum class PartRole {
  // Within a line.
  text,    ///< words of the program
  typed,   ///< words of a person, whose direction of writing affects nothing else; line breaks are kept
  strong,  ///< the words that matter in a line
  code,    ///< checksums and commands

  // Lines.
  title,          ///< of the report
  heading,        ///< of a section
  finding_title,  ///< of a finding
  sentence,       ///< the verdict
  paragraph,      ///< words without anything special
  missing,        ///< why something cannot be shown
  decision,       ///< on a finding that is settled
  open_decision,  ///< on a finding that is not settled
  legend,         ///< what a table or a picture means
  caption,        ///< of a picture
  note,           ///< quoted words of the person that closed the inspection
  warning,        ///< one of `warnings`
  field_name,     ///< one of `fields`, followed by its value
  field_value,    ///< one of `fields`
  foot,           ///< about the report itself

  // Groups.
  head,             ///< title and fields
  fields,           ///< names with their values
  verdict_clear,    ///< the verdict: no debris remains
  verdict_bad,      ///< the verdict: debris remains
  verdict_warning,  ///< the verdict: closed, with a reservation
  verdict_open,     ///< the verdict: not closed
  warnings,         ///< a list
  settings,         ///< in small print
  finding,          ///< is not divided
  figure,           ///< a picture or why there is none, with its caption
  two_figures,      ///< figures, two in a row
  three_figures,    ///< figures, three in a row
  close_ups,        ///< figures of one finding, four in a row
  picture,          ///< ReportPart::picture
  table,            ///< a `table_head` and a `table_body`
  coverage_table,   ///< a table of shares
  events_table,     ///< a table of actions
  checksum_table,   ///< a table of checksums
  table_head,       ///< one row
  table_body,       ///< rows
  row,              ///< cells
  head_cell,        ///< of a row that names the columns
  cell,             ///< of any other row
};

struct ReportPart;

/// Parts of a report, one after another.
class Content {
 public:
  /// Nothing.
  Content() = default;

  /// Words of the program. @see shown_text() for what becomes of bytes that are no text
  [[nodiscard]] static Content text(std::string_view words);
  /// Words of a person.
  [[nodiscard]] static Content typed(std::string_view words);
  /// A picture. @param description for those who do not see it
  [[nodiscard]] static Content picture(const ColorImage& picture, std::string_view description);
  /// A part that consists of others.
  [[nodiscard]] static Content of(PartRole role, Content inside);

  /// Adds a part.
  void append(ReportPart part);
  Content& operator+=(const Content& more);

  [[nodiscard]] const std::vector<ReportPart>& parts() const { return parts_; }
  [[nodiscard]] bool empty() const { return parts_.empty(); }

 private:
  std::vector<ReportPart> parts_;
};

/// A picture as a JPEG file.
struct JpegPicture {
  std::vector<std::byte> jpeg{};
  int width_px = 0;
  int height_px = 0;
};

/// A part of a report.
struct ReportPart {
  PartRole role = PartRole::text;
  std::string words{};    ///< of `text` and `typed`; of a picture, its description
  JpegPicture picture{};  ///< of PartRole::picture
  Content inside{};       ///< of all other roles
};

/// Parts of one, then those of the other.
[[nodiscard]] inline Content operator+(Content first, const Content& second) { return first += second; }

/// A table with a head.
struct ReportTable {
  PartRole role = PartRole::table;
  std::vector<Content> head{};               ///< of each column
  std::vector<std::vector<Content>> rows{};  ///< of as many cells each
};
[[nodiscard]] Content content_of(const ReportTable& table);

/// How many parts of a role there are, at any depth.
[[nodiscard]] std::size_t count_of(PartRole role, const Content& content);

/// The words of all parts, one after another.
[[nodiscard]] std::string words_of(const Content& content);

/// Text that any document may contain: bytes that are not UTF-8, control characters but tab and line feed,
/// and what is no character become U+FFFD.
[[nodiscard]] std::string shown_text(std::string_view words);

}  // namespace rva
