// The list of inspections from SqliteRecords' tables.
#pragma once

#include <SQLiteCpp/Database.h>

#include <vector>

#include "inspect/inspection.hpp"

namespace rva {

/// Newest first, in one query.
[[nodiscard]] std::vector<InspectionSummary> summaries_of(SQLite::Database& database);

}  // namespace rva
