#include "store/round_rows.hpp"

#include <SQLiteCpp/Statement.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "core/json_object.hpp"
#include "store/finding_rows.hpp"

namespace rva {
namespace {

std::optional<TakenSide> final_side_of(SQLite::Database& database, std::int64_t id, int round) {
  SQLite::Statement query(database,
                          "select taken_at, person, base from side where inspection = ? and side = 'final' "
                          "and round = ? and taken_at is not null");
  query.bind(1, id);
  query.bind(2, round);
  if (!query.executeStep()) return std::nullopt;
  return TakenSide{query.getColumn(0), query.getColumn(1), query.getColumn(2), round};
}

nlohmann::json list_of(const std::vector<FindableShare>& shares) {
  nlohmann::json list = nlohmann::json::array();
  for (const FindableShare& share : shares) list.push_back({share.size_mm, share.share});
  return list;
}

std::vector<FindableShare> findable_in(const SQLite::Column& column) {
  std::vector<FindableShare> shares;
  if (column.isNull()) return shares;
  for (const nlohmann::json& pair : nlohmann::json::parse(column.getString()))
    shares.push_back({pair.at(0).get<double>(), pair.at(1).get<double>()});
  return shares;
}

nlohmann::json list_of(const std::vector<PlannedWork>& planned) {
  nlohmann::json list = nlohmann::json::array();
  for (const PlannedWork& work : planned)
    list.push_back(
        {work.name, name_of(work.kind), work.planned, work.found, work.missing, work.not_inspected});
  return list;
}

std::vector<PlannedWork> planned_in(const std::string& text) {
  std::vector<PlannedWork> planned;
  for (const nlohmann::json& row : nlohmann::json::parse(text))
    planned.push_back({row.at(0), value_of<ChangeKind>(row.at(1).get<std::string>()).value(), row.at(2),
                       row.at(3), row.at(4), row.at(5)});
  return planned;
}

}  // namespace

std::optional<RecordedComparison> comparison_of(SQLite::Database& database, std::int64_t id, int number) {
  SQLite::Statement query(
      database,
      "select compared_at, folder, final_round from comparison where inspection = ? and number = ?");
  query.bind(1, id);
  query.bind(2, number);
  if (!query.executeStep()) return std::nullopt;
  return RecordedComparison{number, query.getColumn(0), query.getColumn(1), query.getColumn(2)};
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

std::vector<ComparedView> compared_views_of(SQLite::Database& database, std::int64_t id, int comparison) {
  SQLite::Statement query(
      database,
      "select view, method, compared, unseen, invalid, judged, warnings, left_out, findable, planned "
      "from compared_view where inspection = ? and comparison = ? order by view");
  query.bind(1, id);
  query.bind(2, comparison);
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
    view.findable = findable_in(query.getColumn(8));
    view.planned = planned_in(query.getColumn(9));
    views.push_back(std::move(view));
  }
  return views;
}

std::vector<ComparedRound> rounds_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(
      database,
      "select number from comparison where inspection = ? and compared_at <> '' order by number desc");
  query.bind(1, id);
  std::vector<ComparedRound> rounds;
  while (query.executeStep()) {
    const int number = query.getColumn(0);
    ComparedRound round;
    round.comparison = comparison_of(database, id, number).value();
    round.final = final_side_of(database, id, round.comparison.final_round);
    round.compared = compared_views_of(database, id, number);
    round.findings = findings_of(database, id, number);
    rounds.push_back(std::move(round));
  }
  return rounds;
}

// A comparison that was begun but not completed has an empty time.
void insert_comparison(SQLite::Database& database, std::int64_t id, const RecordedComparison& comparison) {
  SQLite::Statement remove(database,
                           "delete from comparison where inspection = ? and number = ? and compared_at = ''");
  remove.bind(1, id);
  remove.bind(2, comparison.number);
  remove.exec();
  SQLite::Statement insert(database,
                           "insert into comparison (inspection, number, compared_at, folder, final_round) "
                           "values (?, ?, ?, ?, ?)");
  insert.bind(1, id);
  insert.bind(2, comparison.number);
  insert.bind(3, comparison.compared_at);
  insert.bind(4, comparison.folder);
  insert.bind(5, comparison.final_round);
  insert.exec();
}

void insert_compared_views(SQLite::Database& database, std::int64_t id, int comparison,
                           const std::vector<ComparedView>& views) {
  for (const ComparedView& view : views) {
    SQLite::Statement insert(
        database,
        "insert into compared_view (inspection, comparison, view, method, compared, unseen, invalid, judged, "
        "warnings, left_out, findable, planned) values (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, id);
    insert.bind(2, comparison);
    insert.bind(3, view.view);
    insert.bind(4, view.method);
    insert.bind(5, view.coverage.compared);
    insert.bind(6, view.coverage.unseen);
    insert.bind(7, view.coverage.invalid);
    insert.bind(8, view.judged);
    insert.bind(9, json_text(nlohmann::json(view.warnings)));
    if (view.coverage.left_out) insert.bind(10, *view.coverage.left_out);
    insert.bind(11, json_text(list_of(view.findable)));
    insert.bind(12, json_text(list_of(view.planned)));
    insert.exec();
  }
}

void set_current_comparison(SQLite::Database& database, std::int64_t id, int number) {
  SQLite::Statement update(database, "update inspection set comparison = ? where id = ?");
  update.bind(1, number);
  update.bind(2, id);
  update.exec();
}

}  // namespace rva
