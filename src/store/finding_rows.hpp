// Findings as rows of SqliteRecords' tables.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <string>
#include <vector>

#include "inspect/inspection.hpp"

namespace rva {

void insert_finding(SQLite::Database& database, std::int64_t inspection, int comparison,
                    const ReviewedFinding& finding);

/// @return false if there is no such finding, or the comparison is not the current one
[[nodiscard]] bool insert_decision(SQLite::Database& database, std::int64_t inspection, int comparison,
                                   int finding, const Decision& decision);

/// The findings of one comparison in the order of their numbers, each with its latest decision. Their pixels
/// are not stored.
[[nodiscard]] std::vector<ReviewedFinding> findings_of(SQLite::Database& database, std::int64_t inspection,
                                                       int comparison);

}  // namespace rva
