#include "store/sqlite_records.hpp"

#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "inspect/closing.hpp"
#include "store/checkout_rows.hpp"
#include "store/finding_rows.hpp"
#include "store/history_rows.hpp"
#include "store/inspection_rows.hpp"
#include "store/mark_rows.hpp"
#include "store/open_database.hpp"
#include "store/round_rows.hpp"
#include "store/summary_rows.hpp"
#include "store/tally_rows.hpp"

namespace rva {
namespace {

void add_decision(SQLite::Database& database, std::int64_t id, int comparison, const FindingDecision& given) {
  const auto& [number, marked, decision] = given;
  if (marked && !insert_mark_decision(database, id, number, decision))
    throw Error(fmt::format("inspection {}", id), fmt::format("has no finding {} marked by hand", number),
                "reload the list of findings");
  if (!marked && !insert_decision(database, id, comparison, number, decision))
    throw Error(fmt::format("finding {} of inspection {}", number, id),
                "is not a finding of the latest comparison", "reload the list of findings");
}

// Failures of the database, and values in it that this program cannot have written, as errors for the user.
template <typename Work>
auto with_errors(const std::string& source, const Work& work) {
  const auto damaged = [&source] {
    return Error(source, "contains a value that this program did not write", "restore it from a backup");
  };
  try {
    return work();
  } catch (const SQLite::Exception& failure) {
    throw database_error(source, failure);
  } catch (const nlohmann::json::exception&) {
    throw damaged();
  } catch (const std::bad_optional_access&) {
    throw damaged();
  }
}

}  // namespace

SqliteRecords::SqliteRecords(const std::filesystem::path& file)
    : file_(file), source_(printable(file)), database_(open_database(file)) {}

template <typename Work>
auto SqliteRecords::change(const Work& work) {
  const std::lock_guard lock(mutex_);
  return with_errors(source_, [&] {
    SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
    auto result = work(database_);
    transaction.commit();
    return result;
  });
}

// Reads in one transaction, so that all values belong to the same state of the database.
template <typename Work>
auto SqliteRecords::read(const Work& work) const {
  const std::lock_guard lock(mutex_);
  return with_errors(source_, [&] {
    const SQLite::Transaction transaction(database_);
    return work(database_);
  });
}

std::int64_t SqliteRecords::add_inspection(const InspectionOrder& order, const std::string& created_at,
                                           int dither, const std::vector<PanTilt>& views,
                                           std::int64_t above) {
  return change([&](SQLite::Database& database) {
    SQLite::Statement insert(database,
                             "insert into inspection (id, aircraft, zone, work_order, person, created_at, "
                             "dither) values ((select max(?7, inspection) + 1 from greatest_id), "
                             "?1, ?2, ?3, ?4, ?5, ?6)");
    insert.bind(1, order.aircraft);
    insert.bind(2, order.zone);
    insert.bind(3, order.work_order);
    insert.bind(4, order.person);
    insert.bind(5, created_at);
    insert.bind(6, dither);
    insert.bind(7, above);
    insert.exec();
    const std::int64_t id = database.getLastInsertRowid();
    replace_views(database, id, views);
    return id;
  });
}

std::vector<std::int64_t> SqliteRecords::inspections() const {
  return read([](SQLite::Database& database) {
    SQLite::Statement query(database, "select id from inspection order by id desc");
    std::vector<std::int64_t> ids;
    while (query.executeStep()) ids.push_back(query.getColumn(0));
    return ids;
  });
}

std::vector<InspectionSummary> SqliteRecords::summaries(const InspectionFilter& filter) const {
  return read([&](SQLite::Database& database) { return summaries_of(database, filter); });
}

std::vector<InspectionTally> SqliteRecords::tallies(const InspectionFilter& filter) const {
  // With many inspections this takes seconds. A connection of its own keeps other requests from waiting.
  return with_errors(source_, [&] {
    SQLite::Database reader = open_for_reading(file_);
    const SQLite::Transaction transaction(reader);
    return tallies_of(reader, filter);
  });
}

std::optional<RecordedComparison> SqliteRecords::comparison(std::int64_t id, int number) const {
  return read([&](SQLite::Database& database) {
    std::optional<RecordedComparison> found = comparison_of(database, id, number);
    if (found && found->compared_at.empty()) found.reset();  // it was begun, and shows nothing yet
    return found;
  });
}

std::vector<ComparedRound> SqliteRecords::rounds(std::int64_t id) const {
  return read([&](SQLite::Database& database) { return rounds_of(database, id); });
}

std::optional<InspectionHistory> SqliteRecords::history(std::int64_t id) const {
  return read([&](SQLite::Database& database) { return history_of(database, id); });
}

std::optional<Inspection> SqliteRecords::find(std::int64_t id) const {
  return read([&](SQLite::Database& database) { return find_inspection(database, id); });
}

void SqliteRecords::set_views(std::int64_t id, const std::vector<PanTilt>& views) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    replace_views(database, id, views);
    return true;
  });
}

void SqliteRecords::begin_side(std::int64_t id, Side side, const BegunSide& begun) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    insert_side(database, id, side, begun, std::nullopt);
    return true;
  });
}

void SqliteRecords::set_side(std::int64_t id, Side side, const TakenSide& taken) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    insert_side(database, id, side, {taken.round, taken.person, taken.base}, taken.taken_at);
    set_current_comparison(database, id, 0);
    return true;
  });
}

void SqliteRecords::set_ignored(std::int64_t id, int view, const std::vector<Polygon>& ignored) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    SQLite::Statement insert(
        database, "insert or replace into ignored_region (inspection, view, regions) values (?, ?, ?)");
    insert.bind(1, id);
    insert.bind(2, view);
    insert.bind(3, json_text(json_of(IgnoredRegions{ignored, {}})) + "\n");
    insert.exec();
    set_current_comparison(database, id, 0);
    return true;
  });
}

void SqliteRecords::set_plan(std::int64_t id, int view, const Plan* plan) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    replace_plan(database, id, view, plan);
    set_current_comparison(database, id, 0);
    return true;
  });
}

void SqliteRecords::begin_comparison(std::int64_t id, const RecordedComparison& comparison) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    insert_comparison(database, id, comparison);
    return true;
  });
}

void SqliteRecords::set_comparison(std::int64_t id, const RecordedComparison& comparison,
                                   const std::vector<ComparedView>& views,
                                   const std::vector<ReviewedFinding>& findings) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    insert_comparison(database, id, comparison);
    set_current_comparison(database, id, comparison.number);
    insert_compared_views(database, id, comparison.number, views);
    for (const ReviewedFinding& finding : findings) insert_finding(database, id, comparison.number, finding);
    return true;
  });
}

void SqliteRecords::decide(std::int64_t id, int comparison, int finding, const Decision& decision) {
  decide_all(id, comparison, {{finding, false, decision}});
}

int SqliteRecords::add_mark(std::int64_t id, const MarkedFinding& marked) {
  return change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    return insert_mark(database, id, marked);
  });
}

void SqliteRecords::add_items(std::int64_t id, const std::vector<ListedItem>& items,
                              const std::string& person, const std::string& taken_at) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    insert_items(database, id, items, person, taken_at);
    return true;
  });
}

void SqliteRecords::state_item(std::int64_t id, int item, const ItemStatement& statement) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    insert_item_statement(database, id, item, statement);
    return true;
  });
}

int SqliteRecords::add_snapshot(std::int64_t id, const Snapshot& snapshot) {
  return change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    return insert_snapshot(database, id, snapshot);
  });
}

void SqliteRecords::decide_mark(std::int64_t id, int mark, const Decision& decision) {
  decide_all(id, 0, {{mark, true, decision}});
}

void SqliteRecords::decide_all(std::int64_t id, int comparison,
                               const std::vector<FindingDecision>& decisions) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    for (const FindingDecision& one : decisions) add_decision(database, id, comparison, one);
    return true;
  });
}

void SqliteRecords::close(std::int64_t id, const Closing& closing) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    require_closable(find_inspection(database, id).value(), closing);
    insert_closing(database, id, closing);
    return true;
  });
}

void SqliteRecords::remove(std::int64_t id) {
  change([&](SQLite::Database& database) {
    require_open_inspection(database, id);
    remove_unused_inspection(database, id);
    return true;
  });
}

void SqliteRecords::set_account(const Account& account) {
  change([&](SQLite::Database& database) {
    SQLite::Statement insert(database,
                             "insert or replace into account (name, role, password_hash, generation) "
                             "values (?, ?, ?, lower(hex(randomblob(16))))");
    insert.bind(1, account.name);
    insert.bind(2, std::string(name_of(account.role)));
    insert.bind(3, account.password_hash);
    return insert.exec();
  });
}

std::vector<Account> SqliteRecords::accounts() const {
  return read([this](SQLite::Database& database) {
    SQLite::Statement query(database,
                            "select name, role, password_hash, generation from account order by name");
    std::vector<Account> accounts;
    while (query.executeStep()) {
      const std::optional<PersonRole> role = value_of<PersonRole>(query.getColumn(1).getString());
      if (!role) throw Error(source_, "contains an account with an unknown role", "add that account again");
      accounts.push_back({query.getColumn(0), *role, query.getColumn(2), query.getColumn(3)});
    }
    return accounts;
  });
}

bool SqliteRecords::remove_account(const std::string& name) {
  return change([&](SQLite::Database& database) {
    SQLite::Statement remove(database, "delete from account where name = ?");
    remove.bind(1, name);
    return remove.exec() > 0;
  });
}

}  // namespace rva
