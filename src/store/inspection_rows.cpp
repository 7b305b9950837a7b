#include "store/inspection_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/json_object.hpp"
#include "inspect/closing.hpp"
#include "store/checkout_rows.hpp"
#include "store/finding_rows.hpp"
#include "store/mark_rows.hpp"
#include "store/round_rows.hpp"

namespace rva {
namespace {

std::vector<PanTilt> views_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database,
                          "select pan_deg, tilt_deg from view where inspection = ? order by number");
  query.bind(1, id);
  std::vector<PanTilt> views;
  while (query.executeStep()) views.push_back({query.getColumn(0), query.getColumn(1)});
  return views;
}

// The last complete round of each side, and a later one that is under way.
void read_sides(SQLite::Database& database, Inspection& inspection) {
  SQLite::Statement query(database,
                          "select side, round, taken_at, person, base from side where inspection = ? "
                          "order by round");
  query.bind(1, inspection.id);
  while (query.executeStep()) {
    const std::optional<Side> side = value_of<Side>(query.getColumn(0).getString());
    if (!side) continue;
    const int round = query.getColumn(1);
    const std::string person = query.getColumn(3);
    const std::string base = query.getColumn(4);
    if (query.getColumn(2).isNull()) {
      inspection.begun[*side] = {round, person, base};
      continue;
    }
    inspection.begun.erase(*side);
    std::optional<TakenSide>& taken = *side == Side::initial ? inspection.initial : inspection.final;
    taken = TakenSide{query.getColumn(2), person, base, round};
  }
}

std::map<int, std::vector<Polygon>> ignored_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database, "select view, regions from ignored_region where inspection = ?");
  query.bind(1, id);
  std::map<int, std::vector<Polygon>> ignored;
  while (query.executeStep())
    ignored[query.getColumn(0)] = parse_regions(query.getColumn(1).getString(), "regions").ignore;
  return ignored;
}

std::map<int, Plan> plans_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database, "select view, plan from plan where inspection = ?");
  query.bind(1, id);
  std::map<int, Plan> plans;
  while (query.executeStep()) plans[query.getColumn(0)] = parse_plan(query.getColumn(1).getString(), "plan");
  return plans;
}

std::optional<Closing> closing_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database,
                          "select comparison, person, note, closed_at from closing where inspection = ?");
  query.bind(1, id);
  if (!query.executeStep()) return std::nullopt;
  return Closing{.comparison = query.getColumn(0),
                 .person = query.getColumn(1),
                 .note = query.getColumn(2),
                 .closed_at = query.getColumn(3)};
}

}  // namespace

std::optional<Inspection> find_inspection(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database,
                          "select aircraft, zone, work_order, person, created_at, dither, comparison from "
                          "inspection where id = ?");
  query.bind(1, id);
  if (!query.executeStep()) return std::nullopt;
  Inspection inspection;
  inspection.id = id;
  inspection.order = {.aircraft = query.getColumn(0),
                      .zone = query.getColumn(1),
                      .work_order = query.getColumn(2),
                      .person = query.getColumn(3)};
  inspection.created_at = query.getColumn(4).getString();
  inspection.dither = query.getColumn(5);
  inspection.views = views_of(database, id);
  inspection.ignored = ignored_of(database, id);
  inspection.planned = plans_of(database, id);
  read_sides(database, inspection);
  inspection.comparison = comparison_of(database, id, query.getColumn(6));
  inspection.comparisons = comparisons_of(database, id);
  inspection.unfinished_comparisons = unfinished_comparisons_of(database, id);
  if (inspection.comparison) {
    inspection.compared = compared_views_of(database, id, inspection.comparison->number);
    inspection.findings = findings_of(database, id, inspection.comparison->number);
  }
  inspection.marked = marked_findings_of(database, id);
  inspection.snapshots = snapshots_of(database, id);
  inspection.items = items_of(database, id);
  inspection.closing = closing_of(database, id);
  return inspection;
}

void require_open_inspection(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database,
                          "select c.person from inspection i left join closing c on c.inspection = i.id "
                          "where i.id = ?");
  query.bind(1, id);
  if (!query.executeStep())
    throw Error(fmt::format("inspection {}", id), "does not exist", "see the list of inspections");
  if (!query.getColumn(0).isNull()) throw closed_inspection(id, query.getColumn(0));
}

void replace_views(SQLite::Database& database, std::int64_t id, const std::vector<PanTilt>& views) {
  SQLite::Statement remove(database, "delete from view where inspection = ?");
  remove.bind(1, id);
  remove.exec();
  int number = 0;
  for (const PanTilt& view : views) {
    SQLite::Statement insert(database,
                             "insert into view (inspection, number, pan_deg, tilt_deg) values (?, ?, ?, ?)");
    insert.bind(1, id);
    insert.bind(2, number++);
    insert.bind(3, view.pan_deg);
    insert.bind(4, view.tilt_deg);
    insert.exec();
  }
}

void replace_plan(SQLite::Database& database, std::int64_t id, int view, const Plan* plan) {
  SQLite::Statement remove(database, "delete from plan where inspection = ? and view = ?");
  remove.bind(1, id);
  remove.bind(2, view);
  remove.exec();
  if (plan == nullptr) return;
  SQLite::Statement insert(database, "insert into plan (inspection, view, plan) values (?, ?, ?)");
  insert.bind(1, id);
  insert.bind(2, view);
  insert.bind(3, json_text(json_of(*plan)));
  insert.exec();
}

void insert_side(SQLite::Database& database, std::int64_t id, Side side, const BegunSide& round,
                 const std::optional<std::string>& taken_at) {
  SQLite::Statement insert(database,
                           "insert or replace into side (inspection, side, round, taken_at, person, base) "
                           "values (?, ?, ?, ?, ?, ?)");
  insert.bind(1, id);
  insert.bind(2, std::string(name_of(side)));
  insert.bind(3, round.round);
  if (taken_at) insert.bind(4, *taken_at);
  insert.bind(5, round.person);
  insert.bind(6, round.base);
  insert.exec();
}

void insert_closing(SQLite::Database& database, std::int64_t id, const Closing& closing) {
  SQLite::Statement insert(
      database,
      "insert into closing (inspection, comparison, person, note, closed_at) values (?, ?, ?, ?, ?)");
  insert.bind(1, id);
  insert.bind(2, closing.comparison);
  insert.bind(3, closing.person);
  insert.bind(4, closing.note);
  insert.bind(5, closing.closed_at);
  insert.exec();
}

void remove_unused_inspection(SQLite::Database& database, std::int64_t id) {
  for (const char* const table : {"side", "comparison", "mark", "snapshot", "item"}) {
    SQLite::Statement query(database, fmt::format("select 1 from {} where inspection = ?", table));
    query.bind(1, id);
    if (query.executeStep())
      throw Error(fmt::format("inspection {}", id),
                  "has captures, marks, snapshots or a check-out list, which are kept",
                  "close it instead of deleting it");
  }
  for (const char* const remove :
       {"delete from view where inspection = ?", "delete from ignored_region where inspection = ?",
        "delete from plan where inspection = ?", "delete from inspection where id = ?"}) {
    SQLite::Statement statement(database, remove);
    statement.bind(1, id);
    statement.exec();
  }
}

}  // namespace rva
