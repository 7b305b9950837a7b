// Inspections as rows of SqliteRecords' tables.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>
#include <string>

#include "inspect/inspection.hpp"

namespace rva {

/// Empty if there is no inspection with this id.
[[nodiscard]] std::optional<Inspection> find_inspection(SQLite::Database& database, std::int64_t id);

/// @throws Error when there is no inspection with this id
void require_inspection(SQLite::Database& database, std::int64_t id);

/// Replaces the views of an inspection.
void replace_views(SQLite::Database& database, std::int64_t id, const std::vector<PanTilt>& views);

/// Replaces the coverage of an earlier comparison.
void replace_compared_views(SQLite::Database& database, std::int64_t id,
                            const std::vector<ComparedView>& views);

/// Adds a round of a side, or completes one that was begun.
/// @param taken_at ISO 8601; empty while the round is in progress
void insert_side(SQLite::Database& database, std::int64_t id, Side side, const BegunSide& round,
                 const std::optional<std::string>& taken_at);

/// Adds a comparison, or completes one that was begun.
/// @throws SQLite::Exception when the comparison with this number is already complete
void insert_comparison(SQLite::Database& database, std::int64_t id, const RecordedComparison& comparison);

/// Marks the current comparison as outdated and removes its coverage; its findings and the decisions on them
/// stay in the record.
void forget_comparison(SQLite::Database& database, std::int64_t id);

}  // namespace rva
