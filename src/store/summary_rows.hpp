// The list of inspections from SqliteRecords' tables.
#pragma once

#include <SQLiteCpp/Database.h>

#include <vector>

#include "inspect/inspection.hpp"

namespace rva {

/// Summaries of all inspections, newest first, in one query.
[[nodiscard]] std::vector<InspectionSummary> summaries_of(SQLite::Database& database);

}  // namespace rva
