#include "store/checkout_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"

namespace rva {
namespace {

int last_number(SQLite::Database& database, std::int64_t inspection) {
  SQLite::Statement last(database, "select coalesce(max(number), 0) from item where inspection = ?");
  last.bind(1, inspection);
  last.executeStep();
  return last.getColumn(0);
}

std::vector<ItemStatement> statements_on(SQLite::Database& database, std::int64_t inspection, int item) {
  SQLite::Statement query(
      database,
      "select returned, used, lost, released, note, person, stated_at from item_statement "
      "where inspection = ? and item = ? order by id");
  query.bind(1, inspection);
  query.bind(2, item);
  std::vector<ItemStatement> statements;
  while (query.executeStep())
    statements.push_back({.returned = query.getColumn(0),
                          .used = query.getColumn(1),
                          .lost = query.getColumn(2),
                          .released = query.getColumn(3).getInt() != 0,
                          .note = query.getColumn(4),
                          .person = query.getColumn(5),
                          .stated_at = query.getColumn(6)});
  return statements;
}

}  // namespace

void insert_items(SQLite::Database& database, std::int64_t inspection, const std::vector<ListedItem>& items,
                  const std::string& person, const std::string& taken_at) {
  int number = last_number(database, inspection);
  if (static_cast<std::size_t>(number) + items.size() > most_listed_items)
    throw Error(fmt::format("inspection {}", inspection),
                fmt::format("would have {} items in its check-out list",
                            static_cast<std::size_t>(number) + items.size()),
                fmt::format("list at most {}", most_listed_items));
  for (const ListedItem& item : items) {
    SQLite::Statement insert(
        database,
        "insert into item (inspection, number, name, identity, quantity, person, taken_at) "
        "values (?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, inspection);
    insert.bind(2, ++number);
    insert.bind(3, item.name);
    insert.bind(4, item.identity);
    insert.bind(5, item.quantity);
    insert.bind(6, person);
    insert.bind(7, taken_at);
    insert.exec();
  }
}

void insert_item_statement(SQLite::Database& database, std::int64_t inspection, int item,
                           const ItemStatement& statement) {
  const std::string subject = fmt::format("item {} of inspection {}", item, inspection);
  const std::vector<CheckedOutItem> items = items_of(database, inspection);
  const auto found = std::ranges::find(items, item, &CheckedOutItem::number);
  if (found == items.end()) throw Error(subject, "does not exist", "reload the check-out list");
  require_valid(statement, found->item, subject);
  SQLite::Statement insert(
      database,
      "insert into item_statement (inspection, item, returned, used, lost, released, note, "
      "person, stated_at) values (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insert.bind(1, inspection);
  insert.bind(2, item);
  insert.bind(3, statement.returned);
  insert.bind(4, statement.used);
  insert.bind(5, statement.lost);
  insert.bind(6, statement.released ? 1 : 0);
  insert.bind(7, statement.note);
  insert.bind(8, statement.person);
  insert.bind(9, statement.stated_at);
  insert.exec();
}

std::vector<CheckedOutItem> items_of(SQLite::Database& database, std::int64_t inspection) {
  SQLite::Statement query(database,
                          "select number, name, identity, quantity, person, taken_at from item "
                          "where inspection = ? order by number");
  query.bind(1, inspection);
  std::vector<CheckedOutItem> items;
  while (query.executeStep()) {
    const int number = query.getColumn(0);
    items.push_back({.number = number,
                     .item = {query.getColumn(1), query.getColumn(2), query.getColumn(3)},
                     .person = query.getColumn(4),
                     .taken_at = query.getColumn(5),
                     .statements = statements_on(database, inspection, number)});
  }
  return items;
}

}  // namespace rva
