#include "store/sqlite_records.hpp"

#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "store/finding_rows.hpp"
#include "store/schema.hpp"

namespace rva {
namespace {

// Not the first four bytes of the file's header alone: another program's database is refused.
constexpr int our_application = 0x52564131;  // "RVA1"
constexpr int busy_limit_ms = 5000;

Error refused(const std::string& place, const SQLite::Exception& failure) {
  return {place, fmt::format("the database refuses: {}", printable(failure.what())),
          "look at the disk and the file's rights"};
}

SQLite::Database open(const std::filesystem::path& file) {
  try {
    return {file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, busy_limit_ms};
  } catch (const SQLite::Exception& failure) {
    throw refused(printable(file), failure);
  }
}

void require_inspection(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database, "select 1 from inspection where id = ?");
  query.bind(1, id);
  if (!query.executeStep())
    throw Error(fmt::format("inspection {}", id), "there is none", "see the list of inspections");
}

std::vector<PanTilt> views_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database,
                          "select pan_deg, tilt_deg from view where inspection = ? order by number");
  query.bind(1, id);
  std::vector<PanTilt> views;
  while (query.executeStep()) views.push_back({query.getColumn(0), query.getColumn(1)});
  return views;
}

std::optional<TakenSide> side_of(SQLite::Database& database, std::int64_t id, Side side) {
  SQLite::Statement query(database,
                          "select taken_at, person, base from side where inspection = ? and side = ?");
  query.bind(1, id);
  query.bind(2, std::string(name_of(side)));
  if (!query.executeStep()) return std::nullopt;
  return TakenSide{query.getColumn(0), query.getColumn(1), query.getColumn(2)};
}

std::vector<ComparedView> compared_views_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(
      database,
      "select view, method, compared, unseen, invalid, judged, warnings, left_out from compared_view "
      "where inspection = ? order by view");
  query.bind(1, id);
  std::vector<ComparedView> views;
  while (query.executeStep()) {
    ComparedView view;
    view.view = query.getColumn(0);
    view.method = query.getColumn(1).getString();
    view.coverage = {query.getColumn(2), query.getColumn(3), query.getColumn(4), std::nullopt};
    if (!query.getColumn(7).isNull()) view.coverage.left_out = query.getColumn(7).getDouble();
    view.judged = query.getColumn(5);
    view.warnings = nlohmann::json::parse(query.getColumn(6).getString()).get<std::vector<std::string>>();
    views.push_back(std::move(view));
  }
  return views;
}

std::map<int, std::vector<Polygon>> ignored_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database, "select view, regions from ignored_region where inspection = ?");
  query.bind(1, id);
  std::map<int, std::vector<Polygon>> ignored;
  while (query.executeStep())
    ignored[query.getColumn(0)] = parse_regions(query.getColumn(1).getString(), "regions").ignore;
  return ignored;
}

// Its findings and the decisions on them stay in the record.
void forget_comparison(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement forget(database, "update inspection set compared_at = '' where id = ?");
  forget.bind(1, id);
  forget.exec();
  SQLite::Statement remove(database, "delete from compared_view where inspection = ?");
  remove.bind(1, id);
  remove.exec();
}

}  // namespace

SqliteRecords::SqliteRecords(const std::filesystem::path& file)
    : place_(printable(file)), database_(open(file)) {
  try {
    const int application = database_.execAndGet("pragma application_id");
    const int version = database_.execAndGet("pragma user_version");
    const int tables = database_.execAndGet("select count(*) from sqlite_master");
    if (application != our_application && (application != 0 || tables > 0))
      throw Error(place_, "is a database of another program", "give another --data folder");
    if (version > schema_version)
      throw Error(place_, "was written by a newer version of this program", "use that one");
    database_.exec("pragma journal_mode = wal");
    database_.exec("pragma synchronous = full");
    database_.exec("pragma foreign_keys = on");
    if (version < schema_version) {
      SQLite::Transaction transaction(database_);
      if (version == 0) database_.exec(schema);
      database_.exec(schema_2_from_1);
      database_.exec(fmt::format("pragma application_id = {}", our_application));
      database_.exec(fmt::format("pragma user_version = {}", schema_version));
      transaction.commit();
    }
  } catch (const SQLite::Exception& failure) {
    throw refused(place_, failure);
  }
}

template <typename Work>
auto SqliteRecords::change(const Work& work) {
  const std::lock_guard lock(mutex_);
  try {
    SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
    auto result = work(database_);
    transaction.commit();
    return result;
  } catch (const SQLite::Exception& failure) {
    throw refused(place_, failure);
  }
}

// In a transaction too, so that all that is read is of one moment.
template <typename Work>
auto SqliteRecords::read(const Work& work) const {
  const std::lock_guard lock(mutex_);
  try {
    const SQLite::Transaction transaction(database_);
    return work(database_);
  } catch (const SQLite::Exception& failure) {
    throw refused(place_, failure);
  }
}

std::int64_t SqliteRecords::add_inspection(const InspectionOrder& order, const std::string& created_at,
                                           int dither) {
  return change([&](SQLite::Database& database) {
    SQLite::Statement insert(database,
                             "insert into inspection (aircraft, zone, work_order, person, created_at, "
                             "dither) values (?, ?, ?, ?, ?, ?)");
    insert.bind(1, order.aircraft);
    insert.bind(2, order.zone);
    insert.bind(3, order.work_order);
    insert.bind(4, order.person);
    insert.bind(5, created_at);
    insert.bind(6, dither);
    insert.exec();
    return database.getLastInsertRowid();
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

std::optional<Inspection> SqliteRecords::find(std::int64_t id) const {
  return read([&](SQLite::Database& database) -> std::optional<Inspection> {
    SQLite::Statement query(database,
                            "select aircraft, zone, work_order, person, created_at, compared_at, dither from "
                            "inspection where id = ?");
    query.bind(1, id);
    if (!query.executeStep()) return std::nullopt;
    Inspection inspection;
    inspection.id = id;
    inspection.order = {query.getColumn(0), query.getColumn(1), query.getColumn(2), query.getColumn(3)};
    inspection.created_at = query.getColumn(4).getString();
    inspection.compared_at = query.getColumn(5).getString();
    inspection.dither = query.getColumn(6);
    inspection.views = views_of(database, id);
    inspection.ignored = ignored_of(database, id);
    inspection.initial = side_of(database, id, Side::initial);
    inspection.final = side_of(database, id, Side::final);
    inspection.compared = compared_views_of(database, id);
    inspection.findings = findings_of(database, id, inspection.compared_at);
    return inspection;
  });
}

void SqliteRecords::set_views(std::int64_t id, const std::vector<PanTilt>& views) {
  change([&](SQLite::Database& database) {
    require_inspection(database, id);
    SQLite::Statement remove(database, "delete from view where inspection = ?");
    remove.bind(1, id);
    remove.exec();
    int number = 0;
    for (const PanTilt& view : views) {
      SQLite::Statement insert(
          database, "insert into view (inspection, number, pan_deg, tilt_deg) values (?, ?, ?, ?)");
      insert.bind(1, id);
      insert.bind(2, number++);
      insert.bind(3, view.pan_deg);
      insert.bind(4, view.tilt_deg);
      insert.exec();
    }
    return true;
  });
}

void SqliteRecords::set_side(std::int64_t id, Side side, const TakenSide& taken) {
  change([&](SQLite::Database& database) {
    require_inspection(database, id);
    SQLite::Statement insert(
        database,
        "insert or replace into side (inspection, side, taken_at, person, base) values (?, ?, ?, ?, ?)");
    insert.bind(1, id);
    insert.bind(2, std::string(name_of(side)));
    insert.bind(3, taken.taken_at);
    insert.bind(4, taken.person);
    insert.bind(5, taken.base);
    insert.exec();
    forget_comparison(database, id);
    return true;
  });
}

void SqliteRecords::set_ignored(std::int64_t id, int view, const std::vector<Polygon>& ignored) {
  change([&](SQLite::Database& database) {
    require_inspection(database, id);
    SQLite::Statement insert(
        database, "insert or replace into ignored_region (inspection, view, regions) values (?, ?, ?)");
    insert.bind(1, id);
    insert.bind(2, view);
    insert.bind(3, to_json(IgnoredRegions{ignored, {}}));
    insert.exec();
    forget_comparison(database, id);
    return true;
  });
}

void SqliteRecords::set_comparison(std::int64_t id, const std::string& compared_at,
                                   const std::vector<ComparedView>& views,
                                   const std::vector<ReviewedFinding>& findings) {
  change([&](SQLite::Database& database) {
    require_inspection(database, id);
    SQLite::Statement update(database, "update inspection set compared_at = ? where id = ?");
    update.bind(1, compared_at);
    update.bind(2, id);
    update.exec();
    SQLite::Statement remove(database, "delete from compared_view where inspection = ?");
    remove.bind(1, id);
    remove.exec();
    for (const ComparedView& view : views) {
      SQLite::Statement insert(
          database,
          "insert into compared_view (inspection, view, method, compared, unseen, invalid, judged, warnings, "
          "left_out) values (?, ?, ?, ?, ?, ?, ?, ?, ?)");
      insert.bind(1, id);
      insert.bind(2, view.view);
      insert.bind(3, view.method);
      insert.bind(4, view.coverage.compared);
      insert.bind(5, view.coverage.unseen);
      insert.bind(6, view.coverage.invalid);
      insert.bind(7, view.judged);
      insert.bind(8, nlohmann::json(view.warnings).dump());
      if (view.coverage.left_out) insert.bind(9, *view.coverage.left_out);
      insert.exec();
    }
    for (const ReviewedFinding& finding : findings) insert_finding(database, id, compared_at, finding);
    return true;
  });
}

void SqliteRecords::decide(std::int64_t id, const std::string& compared_at, int finding,
                           const Decision& decision) {
  change([&](SQLite::Database& database) {
    SQLite::Statement insert(
        database,
        "insert into decision (inspection, compared_at, finding, verdict, note, person, decided_at) "
        "select f.inspection, f.compared_at, f.number, ?, ?, ?, ? from finding f join inspection i "
        "on i.id = f.inspection and i.compared_at = f.compared_at where f.inspection = ? and f.number = ? "
        "and f.compared_at = ?");
    insert.bind(1, std::string(name_of(decision.verdict)));
    insert.bind(2, decision.note);
    insert.bind(3, decision.person);
    insert.bind(4, decision.decided_at);
    insert.bind(5, id);
    insert.bind(6, finding);
    insert.bind(7, compared_at);
    if (insert.exec() == 0)
      throw Error(fmt::format("finding {} of inspection {}", finding, id),
                  "is none of those that were found last", "load the list of findings again");
    return true;
  });
}

void SqliteRecords::set_account(const Account& account) {
  change([&](SQLite::Database& database) {
    SQLite::Statement insert(database,
                             "insert or replace into account (name, role, password_hash) values (?, ?, ?)");
    insert.bind(1, account.name);
    insert.bind(2, std::string(name_of(account.role)));
    insert.bind(3, account.password_hash);
    return insert.exec();
  });
}

std::vector<Account> SqliteRecords::accounts() const {
  return read([this](SQLite::Database& database) {
    SQLite::Statement query(database, "select name, role, password_hash from account order by name");
    std::vector<Account> accounts;
    while (query.executeStep()) {
      const std::optional<PersonRole> role = role_from_name(query.getColumn(1).getString());
      if (!role) throw Error(place_, "holds an account with an unknown role", "add that account anew");
      accounts.push_back({query.getColumn(0), *role, query.getColumn(2)});
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
