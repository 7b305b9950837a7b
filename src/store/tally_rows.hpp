// Tallies of inspections from the tables of SqliteRecords.
#pragma once

#include <SQLiteCpp/Database.h>

#include <vector>

#include "inspect/inspection.hpp"
#include "inspect/inspection_tally.hpp"

namespace rva {

/// Those that a filter selects, newest first.
[[nodiscard]] std::vector<InspectionTally> tallies_of(SQLite::Database& database,
                                                      const InspectionFilter& filter);

}  // namespace rva
