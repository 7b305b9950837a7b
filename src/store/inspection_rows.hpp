// Inspections as rows of SqliteRecords' tables.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>
#include <string>

#include "inspect/inspection.hpp"

namespace rva {

/// Empty where there is none of this id.
[[nodiscard]] std::optional<Inspection> find_inspection(SQLite::Database& database, std::int64_t id);

/// @throws Error where there is none of this id
void require_inspection(SQLite::Database& database, std::int64_t id);

/// Takes the place of the views that it had.
void replace_views(SQLite::Database& database, std::int64_t id, const std::vector<PanTilt>& views);

/// Takes the place of the coverage of an earlier comparison.
void replace_compared_views(SQLite::Database& database, std::int64_t id,
                            const std::vector<ComparedView>& views);

/// Adds a round of a side, or completes one that was begun.
/// @param taken_at ISO 8601; empty while it is under way
void insert_side(SQLite::Database& database, std::int64_t id, Side side, const BegunSide& round,
                 const std::optional<std::string>& taken_at);

/// Adds it, or completes one that was begun. @throws SQLite::Exception when one of this number is complete
void insert_comparison(SQLite::Database& database, std::int64_t id, const RecordedComparison& comparison);

/// The comparison holds no more; its findings and the decisions on them stay in the record.
void forget_comparison(SQLite::Database& database, std::int64_t id);

}  // namespace rva
