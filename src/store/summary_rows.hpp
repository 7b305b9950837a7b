// The list of inspections from SqliteRecords' tables.
#pragma once

#include <SQLiteCpp/Database.h>

#include <vector>

#include "inspect/inspection.hpp"

namespace rva {

/// Summaries of the inspections that a filter selects, newest first, in one query.
[[nodiscard]] std::vector<InspectionSummary> summaries_of(SQLite::Database& database,
                                                          const InspectionFilter& filter);

}  // namespace rva
