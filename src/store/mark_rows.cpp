#include "store/mark_rows.hpp"

#include <SQLiteCpp/Statement.h>

#include <optional>
#include <string>
#include <utility>

#include "store/columns.hpp"

namespace rva {
namespace {

std::optional<Decision> last_decision(SQLite::Database& database, std::int64_t inspection, int mark) {
  SQLite::Statement query(database,
                          "select verdict, note, person, decided_at, round, object from mark_decision "
                          "where inspection = ? and mark = ? order by id desc limit 1");
  query.bind(1, inspection);
  query.bind(2, mark);
  return query.executeStep() ? decision_in(query) : std::nullopt;
}

}  // namespace

int insert_mark(SQLite::Database& database, std::int64_t inspection, const MarkedFinding& marked) {
  SQLite::Statement last(database, "select coalesce(max(number), 0) from mark where inspection = ?");
  last.bind(1, inspection);
  last.executeStep();
  const int number = last.getColumn(0).getInt() + 1;
  SQLite::Statement insert(database,
                           "insert into mark (inspection, number, view, comparison, round, picture, box, "
                           "position_m, in_foot_m, size_mm, note, person, marked_at) "
                           "values (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insert.bind(1, inspection);
  insert.bind(2, number);
  if (marked.view) insert.bind(3, *marked.view);
  insert.bind(4, marked.comparison);
  insert.bind(5, marked.round);
  insert.bind(6, marked.picture);
  bind_value(insert, 7, marked.box);
  bind_value(insert, 8, marked.position_m);
  bind_value(insert, 9, marked.in_foot_m);
  bind_value(insert, 10, marked.size_mm);
  insert.bind(11, marked.note);
  insert.bind(12, marked.person);
  insert.bind(13, marked.marked_at);
  insert.exec();
  return number;
}

bool insert_mark_decision(SQLite::Database& database, std::int64_t inspection, int mark,
                          const Decision& decision) {
  SQLite::Statement insert(
      database,
      "insert into mark_decision (inspection, mark, round, verdict, note, person, decided_at, object) "
      "select inspection, number, ?, ?, ?, ?, ?, ? from mark where inspection = ? and number = ?");
  insert.bind(1, decision.round);
  insert.bind(2, std::string(name_of(decision.verdict)));
  insert.bind(3, decision.note);
  insert.bind(4, decision.person);
  insert.bind(5, decision.decided_at);
  insert.bind(6, decision.object);
  insert.bind(7, inspection);
  insert.bind(8, mark);
  return insert.exec() > 0;
}

std::vector<MarkedFinding> marked_findings_of(SQLite::Database& database, std::int64_t inspection) {
  SQLite::Statement query(database, "select * from mark where inspection = ? order by number");
  query.bind(1, inspection);
  std::vector<MarkedFinding> all;
  while (query.executeStep()) {
    MarkedFinding marked;
    marked.number = query.getColumn("number");
    if (const SQLite::Column view = query.getColumn("view"); !view.isNull()) marked.view = view.getInt();
    marked.comparison = query.getColumn("comparison");
    marked.round = query.getColumn("round");
    marked.picture = query.getColumn("picture").getString();
    marked.box = box_in(query.getColumn("box"));
    marked.position_m = point_in(query.getColumn("position_m"));
    marked.in_foot_m = point_in(query.getColumn("in_foot_m"));
    marked.size_mm = extent_in(query.getColumn("size_mm"));
    marked.note = query.getColumn("note").getString();
    marked.person = query.getColumn("person").getString();
    marked.marked_at = query.getColumn("marked_at").getString();
    marked.decision = last_decision(database, inspection, marked.number);
    all.push_back(std::move(marked));
  }
  return all;
}

int insert_snapshot(SQLite::Database& database, std::int64_t inspection, const Snapshot& snapshot) {
  SQLite::Statement insert(database,
                           "insert into snapshot (inspection, number, picture, note, person, taken_at) "
                           "select ?1, coalesce(max(number), 0) + 1, ?2, ?3, ?4, ?5 from snapshot "
                           "where inspection = ?1 returning number");
  insert.bind(1, inspection);
  insert.bind(2, snapshot.picture);
  insert.bind(3, snapshot.note);
  insert.bind(4, snapshot.person);
  insert.bind(5, snapshot.taken_at);
  insert.executeStep();
  const int number = insert.getColumn(0);
  while (insert.executeStep()) continue;
  return number;
}

std::vector<Snapshot> snapshots_of(SQLite::Database& database, std::int64_t inspection) {
  SQLite::Statement query(database, "select * from snapshot where inspection = ? order by number");
  query.bind(1, inspection);
  std::vector<Snapshot> all;
  while (query.executeStep()) {
    all.push_back({query.getColumn("number").getInt(), query.getColumn("picture").getString(),
                   query.getColumn("note").getString(), query.getColumn("person").getString(),
                   query.getColumn("taken_at").getString()});
  }
  return all;
}

}  // namespace rva
