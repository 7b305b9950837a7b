// Findings that people marked, and pictures that they kept, as rows of SqliteRecords' tables.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <vector>

#include "inspect/inspection.hpp"

namespace rva {

/// @return the number that it was given, one above the greatest of its inspection
int insert_mark(SQLite::Database& database, std::int64_t inspection, const MarkedFinding& marked);

/// @return false if there is no such mark
[[nodiscard]] bool insert_mark_decision(SQLite::Database& database, std::int64_t inspection, int mark,
                                        const Decision& decision);

/// @return the number that it was given, one above the greatest of its inspection
int insert_snapshot(SQLite::Database& database, std::int64_t inspection, const Snapshot& snapshot);

/// In the order of their numbers.
[[nodiscard]] std::vector<Snapshot> snapshots_of(SQLite::Database& database, std::int64_t inspection);

/// In the order of their numbers, each with its latest decision.
[[nodiscard]] std::vector<MarkedFinding> marked_findings_of(SQLite::Database& database,
                                                            std::int64_t inspection);

}  // namespace rva
