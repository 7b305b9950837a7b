#include "store/finding_rows.hpp"

#include <SQLiteCpp/Statement.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/json_object.hpp"
#include "store/columns.hpp"

namespace rva {
namespace {

using nlohmann::json;

std::optional<Decision> last_decision(SQLite::Database& database, std::int64_t inspection, int comparison,
                                      int finding) {
  SQLite::Statement query(
      database,
      "select verdict, note, person, decided_at, round, object from decision where inspection = ? "
      "and comparison = ? and finding = ? order by id desc limit 1");
  query.bind(1, inspection);
  query.bind(2, comparison);
  query.bind(3, finding);
  return query.executeStep() ? decision_in(query) : std::nullopt;
}

Finding finding_of(SQLite::Statement& row) {
  Finding finding;
  finding.id = row.getColumn("number");
  finding.kind = value_of<ChangeKind>(row.getColumn("kind").getString()).value_or(ChangeKind::appearance);
  finding.box = box_in(row.getColumn("box"));
  const auto centroid = extent_in(row.getColumn("centroid")).value();
  finding.centroid = {centroid[0], centroid[1]};
  finding.position_m = point_in(row.getColumn("position_m"));
  finding.size_mm = extent_in(row.getColumn("size_mm"));
  finding.height_mm = number_in(row.getColumn("height_mm"));
  finding.above_surroundings_mm = number_in(row.getColumn("above_surroundings_mm"));
  finding.top_above_surroundings_mm = number_in(row.getColumn("top_above_surroundings_mm"));
  finding.top_is_least = row.getColumn("top_is_least").getInt() != 0;
  finding.background_jump = row.getColumn("background_jump").getInt() != 0;
  finding.score = number_in(row.getColumn("score"));
  finding.p_value = number_in(row.getColumn("p_value"));
  finding.evidence = {row.getColumn("by_depth").getInt() != 0, row.getColumn("by_appearance").getInt() != 0};
  return finding;
}

}  // namespace

void insert_finding(SQLite::Database& database, std::int64_t inspection, int comparison,
                    const ReviewedFinding& reviewed) {
  const Finding& finding = reviewed.finding;
  const Box& box = finding.box;
  SQLite::Statement insert(database,
                           "insert into finding (inspection, comparison, number, view, same_as, kind, box, "
                           "centroid, position_m, in_foot_m, size_mm, height_mm, score, p_value, moved_from, "
                           "by_depth, by_appearance, above_surroundings_mm, background_jump, "
                           "top_above_surroundings_mm, top_is_least, clear_px, planned, planned_item, "
                           "likely_class, class_probability) values (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
                           "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  insert.bind(1, inspection);
  insert.bind(2, comparison);
  insert.bind(3, reviewed.number);
  insert.bind(4, reviewed.view);
  insert.bind(5, reviewed.same_as);
  insert.bind(6, std::string(name_of(finding.kind)));
  bind_value(insert, 7, box);
  insert.bind(8, json_text(json{finding.centroid.x(), finding.centroid.y()}));
  bind_value(insert, 9, finding.position_m);
  bind_value(insert, 10, reviewed.in_foot_m);
  bind_value(insert, 11, finding.size_mm);
  bind_value(insert, 12, finding.height_mm);
  bind_value(insert, 13, finding.score);
  bind_value(insert, 14, finding.p_value);
  if (reviewed.moved_from) insert.bind(15, *reviewed.moved_from);
  insert.bind(16, finding.evidence.depth ? 1 : 0);
  insert.bind(17, finding.evidence.appearance ? 1 : 0);
  bind_value(insert, 18, finding.above_surroundings_mm);
  insert.bind(19, finding.background_jump ? 1 : 0);
  bind_value(insert, 20, finding.top_above_surroundings_mm);
  insert.bind(21, finding.top_is_least ? 1 : 0);
  if (reviewed.clear_px) insert.bind(22, *reviewed.clear_px);
  insert.bind(23, reviewed.planned ? std::string(name_of(*reviewed.planned)) : "");
  insert.bind(24, reviewed.planned_item);
  insert.bind(25, reviewed.likely_class);
  bind_value(insert, 26, reviewed.class_probability);
  insert.exec();
}

bool insert_decision(SQLite::Database& database, std::int64_t inspection, int comparison, int finding,
                     const Decision& decision) {
  SQLite::Statement insert(
      database,
      "insert into decision (inspection, comparison, finding, verdict, note, person, decided_at, round, "
      "object) "
      "select f.inspection, f.comparison, f.number, ?, ?, ?, ?, ?, ? from finding f join inspection i "
      "on i.id = f.inspection and i.comparison = f.comparison where f.inspection = ? and f.number = ? "
      "and f.comparison = ?");
  insert.bind(1, std::string(name_of(decision.verdict)));
  insert.bind(2, decision.note);
  insert.bind(3, decision.person);
  insert.bind(4, decision.decided_at);
  insert.bind(5, decision.round);
  insert.bind(6, decision.object);
  insert.bind(7, inspection);
  insert.bind(8, finding);
  insert.bind(9, comparison);
  return insert.exec() > 0;
}

std::vector<ReviewedFinding> findings_of(SQLite::Database& database, std::int64_t inspection,
                                         int comparison) {
  SQLite::Statement query(database,
                          "select * from finding where inspection = ? and comparison = ? order by number");
  query.bind(1, inspection);
  query.bind(2, comparison);
  std::vector<ReviewedFinding> findings;
  while (query.executeStep()) {
    ReviewedFinding finding;
    finding.number = query.getColumn("number");
    finding.view = query.getColumn("view");
    finding.same_as = query.getColumn("same_as");
    finding.finding = finding_of(query);
    finding.in_foot_m = point_in(query.getColumn("in_foot_m"));
    if (const SQLite::Column moved_from = query.getColumn("moved_from"); !moved_from.isNull())
      finding.moved_from = moved_from.getInt();
    if (const SQLite::Column clear_px = query.getColumn("clear_px"); !clear_px.isNull())
      finding.clear_px = clear_px.getInt();
    finding.planned = value_of<PlannedState>(query.getColumn("planned").getString());
    finding.planned_item = query.getColumn("planned_item").getString();
    finding.likely_class = query.getColumn("likely_class").getString();
    finding.class_probability = number_in(query.getColumn("class_probability"));
    finding.decision = last_decision(database, inspection, comparison, finding.number);
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace rva
