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

/// Of one comparison, each with its last decision. Their pixels are not kept here.
[[nodiscard]] std::vector<ReviewedFinding> findings_of(SQLite::Database& database, std::int64_t inspection,
                                                       int comparison);

}  // namespace rva
