// Comma-separated values (RFC 4180), as spreadsheets write them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rva {

/// A record of a CSV file.
struct CsvRecord {
  std::size_t line = 0;             ///< where it begins, from 1
  std::vector<std::string> fields;  ///< at least one
};

/// Reads all records. Fields are separated by commas or, where the first line outside quotes has more of
/// them, by semicolons or tabs, which some spreadsheets write in countries with a decimal comma. Quoted
/// fields may contain separators, doubled quotes and line ends. A byte order mark and empty lines are left
/// out.
/// @param text   UTF-8
/// @param source where it is from, for errors
/// @throws Error when the text is not UTF-8, a quote is not closed, or text follows a closing quote
[[nodiscard]] std::vector<CsvRecord> parse_csv(std::string_view text, const std::string& source);

}  // namespace rva
