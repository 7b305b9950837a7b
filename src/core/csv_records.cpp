#include "core/csv_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// The separator that occurs most often outside quotes in the first line.
char separator_of(std::string_view text) {
  constexpr std::array separators{',', ';', '\t'};
  std::array<int, separators.size()> counts{};
  bool quoted = false;
  for (const char character : text) {
    if (character == '"') quoted = !quoted;
    if (quoted) continue;
    if (character == '\n') break;
    for (std::size_t k = 0; k < separators.size(); ++k)
      if (character == separators.at(k)) ++counts.at(k);
  }
  return separators.at(static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin()));
}

/// Reads one text from its beginning to its end.
class Reader {
 public:
  Reader(std::string_view text, const std::string& source)
      : rest_(text), separator_(separator_of(text)), source_(source) {}

  std::vector<CsvRecord> records() {
    std::vector<CsvRecord> records;
    while (!rest_.empty()) {
      CsvRecord record{line_, fields()};
      const bool is_empty_line = record.fields.size() == 1 && record.fields.front().empty();
      if (!is_empty_line) records.push_back(std::move(record));
    }
    return records;
  }

 private:
  // Up to the end of the record, which is taken, too.
  std::vector<std::string> fields() {
    std::vector<std::string> fields{field()};
    while (take(separator_)) fields.push_back(field());
    if (!take_line_end() && !rest_.empty()) throw wrong("has text after a closing quote");
    return fields;
  }

  std::string field() {
    if (take('"')) return quoted_field();
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.find(separator_));
    const std::string field(rest_.substr(0, end));
    rest_.remove_prefix(field.size());
    return field;
  }

  std::string quoted_field() {
    std::string field;
    const std::size_t opened = line_;
    do {
      const std::size_t end = rest_.find('"');
      if (end == rest_.npos)
        throw Error(fmt::format("{}, line {}", source_, opened), "has a quote that is not closed",
                    "close it, or save the file as CSV anew");
      field += rest_.substr(0, end);
      line_ += static_cast<std::size_t>(std::ranges::count(rest_.substr(0, end), '\n'));
      rest_.remove_prefix(end + 1);
      if (rest_.starts_with('"')) field += '"';
    } while (take('"'));
    return field;
  }

  bool take(char character) {
    if (!rest_.starts_with(character)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  bool take_line_end() {
    const bool carriage_return = take('\r');
    if (!take('\n') && !carriage_return) return false;
    ++line_;
    return true;
  }

  [[nodiscard]] Error wrong(const char* problem) const {
    return {fmt::format("{}, line {}", source_, line_), problem, "save the file as CSV anew"};
  }

  std::string_view rest_;
  char separator_;
  const std::string& source_;
  std::size_t line_ = 1;
};

}  // namespace

std::vector<CsvRecord> parse_csv(std::string_view text, const std::string& source) {
  if (!is_utf8(text)) throw Error(source, "is not text in UTF-8", "save the file as CSV in UTF-8");
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return Reader(text, source).records();
}

}  // namespace rva
