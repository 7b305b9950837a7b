#include "store/inspection_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/json_object.hpp"
#include "store/finding_rows.hpp"

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
    view.coverage = {
        .compared = query.getColumn(2), .unseen = query.getColumn(3), .invalid = query.getColumn(4)};
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

std::optional<RecordedComparison> comparison_of(SQLite::Database& database, std::int64_t id, int number) {
  SQLite::Statement query(database,
                          "select compared_at, folder from comparison where inspection = ? and number = ?");
  query.bind(1, id);
  query.bind(2, number);
  if (!query.executeStep()) return std::nullopt;
  return RecordedComparison{number, query.getColumn(0), query.getColumn(1)};
}

int comparisons_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database, "select coalesce(max(number), 0) from comparison where inspection = ?");
  query.bind(1, id);
  query.executeStep();
  return query.getColumn(0);
}

std::vector<std::string> unfinished_comparisons_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database,
                          "select folder from comparison where inspection = ? and compared_at = ''");
  query.bind(1, id);
  std::vector<std::string> folders;
  while (query.executeStep()) folders.push_back(query.getColumn(0));
  return folders;
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
  read_sides(database, inspection);
  inspection.comparison = comparison_of(database, id, query.getColumn(6));
  inspection.comparisons = comparisons_of(database, id);
  inspection.unfinished_comparisons = unfinished_comparisons_of(database, id);
  inspection.compared = compared_views_of(database, id);
  if (inspection.comparison) inspection.findings = findings_of(database, id, inspection.comparison->number);
  return inspection;
}

void require_inspection(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database, "select 1 from inspection where id = ?");
  query.bind(1, id);
  if (!query.executeStep())
    throw Error(fmt::format("inspection {}", id), "does not exist", "see the list of inspections");
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

void replace_compared_views(SQLite::Database& database, std::int64_t id,
                            const std::vector<ComparedView>& views) {
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
    insert.bind(8, json_text(nlohmann::json(view.warnings)));
    if (view.coverage.left_out) insert.bind(9, *view.coverage.left_out);
    insert.exec();
  }
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

// A comparison that was begun but not completed has an empty time.
void insert_comparison(SQLite::Database& database, std::int64_t id, const RecordedComparison& comparison) {
  SQLite::Statement remove(database,
                           "delete from comparison where inspection = ? and number = ? and compared_at = ''");
  remove.bind(1, id);
  remove.bind(2, comparison.number);
  remove.exec();
  SQLite::Statement insert(
      database, "insert into comparison (inspection, number, compared_at, folder) values (?, ?, ?, ?)");
  insert.bind(1, id);
  insert.bind(2, comparison.number);
  insert.bind(3, comparison.compared_at);
  insert.bind(4, comparison.folder);
  insert.exec();
}

void forget_comparison(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement forget(database, "update inspection set comparison = 0 where id = ?");
  forget.bind(1, id);
  forget.exec();
  replace_compared_views(database, id, {});
}

}  // namespace rva
