// All that SqliteRecords' tables contain of an inspection.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>

#include "inspect/inspection.hpp"

namespace rva {

/// Empty if there is no inspection with this id.
[[nodiscard]] std::optional<InspectionHistory> history_of(SQLite::Database& database, std::int64_t id);

}  // namespace rva
