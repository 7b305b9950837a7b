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

/// @throws Error when there is no inspection with this id, or it has been closed
void require_open_inspection(SQLite::Database& database, std::int64_t id);

/// Replaces the views of an inspection.
/// Replaces the plan of a view; null removes it.
void replace_plan(SQLite::Database& database, std::int64_t id, int view, const Plan* plan);

void replace_views(SQLite::Database& database, std::int64_t id, const std::vector<PanTilt>& views);

/// Adds a round of a side, or completes one that was begun.
/// @param taken_at ISO 8601; empty while the round is in progress
void insert_side(SQLite::Database& database, std::int64_t id, Side side, const BegunSide& round,
                 const std::optional<std::string>& taken_at);

/// Records that an open inspection is closed.
void insert_closing(SQLite::Database& database, std::int64_t id, const Closing& closing);

/// Removes an inspection of which nothing has been captured, compared or marked.
/// @throws Error when something has
void remove_unused_inspection(SQLite::Database& database, std::int64_t id);

}  // namespace rva
