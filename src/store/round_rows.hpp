// Comparisons as rows of SqliteRecords' tables.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "inspect/inspection.hpp"

namespace rva {

/// Empty if there is no comparison with this number.
[[nodiscard]] std::optional<RecordedComparison> comparison_of(SQLite::Database& database, std::int64_t id,
                                                              int number);
/// The highest number of a comparison, unfinished ones included; 0 if there is none.
[[nodiscard]] int comparisons_of(SQLite::Database& database, std::int64_t id);
/// Folders of comparisons that were begun but not completed.
[[nodiscard]] std::vector<std::string> unfinished_comparisons_of(SQLite::Database& database, std::int64_t id);
/// The coverage of a comparison, by view.
[[nodiscard]] std::vector<ComparedView> compared_views_of(SQLite::Database& database, std::int64_t id,
                                                          int comparison);
/// All complete comparisons, newest first.
[[nodiscard]] std::vector<ComparedRound> rounds_of(SQLite::Database& database, std::int64_t id);

/// Adds a comparison, or completes one that was begun.
/// @throws SQLite::Exception when the comparison with this number is already complete
void insert_comparison(SQLite::Database& database, std::int64_t id, const RecordedComparison& comparison);

void insert_compared_views(SQLite::Database& database, std::int64_t id, int comparison,
                           const std::vector<ComparedView>& views);

/// Makes this comparison the current one; 0 for none. What earlier ones showed stays in the record.
void set_current_comparison(SQLite::Database& database, std::int64_t id, int number);

}  // namespace rva
