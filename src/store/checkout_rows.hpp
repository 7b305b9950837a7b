// Check-out lists as rows of SqliteRecords' tables.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <string>
#include <vector>

#include "inspect/checkout.hpp"

namespace rva {

/// Appends items to the list of an inspection, with the numbers that follow its last one.
/// @throws Error when the list would have more than most_listed_items
void insert_items(SQLite::Database& database, std::int64_t inspection, const std::vector<ListedItem>& items,
                  const std::string& person, const std::string& taken_at);

/// @throws Error when there is no such item, or it may not be stated so (require_valid())
void insert_item_statement(SQLite::Database& database, std::int64_t inspection, int item,
                           const ItemStatement& statement);

/// In the order of their numbers, with all statements.
[[nodiscard]] std::vector<CheckedOutItem> items_of(SQLite::Database& database, std::int64_t inspection);

}  // namespace rva
