#include "store/history_rows.hpp"

#include <SQLiteCpp/Statement.h>

#include <string>
#include <vector>

#include "store/columns.hpp"
#include "store/inspection_rows.hpp"
#include "store/round_rows.hpp"

namespace rva {
namespace {

std::vector<CapturedRound> captured_rounds_of(SQLite::Database& database, std::int64_t id) {
  SQLite::Statement query(database,
                          "select side, taken_at, person, base, round from side "
                          "where inspection = ? and taken_at is not null order by side = 'final', round");
  query.bind(1, id);
  std::vector<CapturedRound> rounds;
  while (query.executeStep()) {
    const std::optional<Side> side = value_of<Side>(query.getColumn(0).getString());
    if (!side) continue;
    rounds.push_back(
        {*side, {query.getColumn(1), query.getColumn(2), query.getColumn(3), query.getColumn(4)}});
  }
  return rounds;
}

// @param select first the columns of recorded_decision_in(), then comparison and number of the finding
void read_decisions(SQLite::Database& database, const std::string& select, std::int64_t id,
                    std::vector<RecordedDecision>& decisions) {
  SQLite::Statement query(database, select);
  query.bind(1, id);
  while (query.executeStep())
    decisions.push_back({query.getColumn(6), query.getColumn(7), recorded_decision_in(query)});
}

std::vector<RecordedDecision> decisions_of(SQLite::Database& database, std::int64_t id) {
  std::vector<RecordedDecision> decisions;
  read_decisions(database,
                 "select verdict, note, person, decided_at, round, object, comparison, finding from decision "
                 "where inspection = ? order by id",
                 id, decisions);
  read_decisions(database,
                 "select verdict, note, person, decided_at, round, object, 0, mark from mark_decision "
                 "where inspection = ? order by id",
                 id, decisions);
  return decisions;
}

}  // namespace

std::optional<InspectionHistory> history_of(SQLite::Database& database, std::int64_t id) {
  std::optional<Inspection> inspection = find_inspection(database, id);
  if (!inspection) return std::nullopt;
  return InspectionHistory{*std::move(inspection), captured_rounds_of(database, id), rounds_of(database, id),
                           decisions_of(database, id)};
}

}  // namespace rva
