// Findings that people marked as rows of SqliteRecords' tables.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <vector>

#include "inspect/reviewed_finding.hpp"

namespace rva {

/// @return the number that it was given, one above the greatest of its inspection
int insert_mark(SQLite::Database& database, std::int64_t inspection, const MarkedFinding& marked);

/// @return false if there is no such mark
[[nodiscard]] bool insert_mark_decision(SQLite::Database& database, std::int64_t inspection, int mark,
                                        const Decision& decision);

/// In the order of their numbers, each with its latest decision.
[[nodiscard]] std::vector<MarkedFinding> marked_findings_of(SQLite::Database& database,
                                                            std::int64_t inspection);

}  // namespace rva
