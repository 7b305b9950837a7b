#include "store/tally_rows.hpp"

#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <string>
#include <utility>

#include "store/summary_rows.hpp"

namespace rva {
namespace {

constexpr const char* comparisons = R"sql(
select inspection, count(*) from comparison where compared_at <> '' group by inspection
)sql";

// Findings with the same `same_as` show one object; the decision on the most suspicious one, which has the
// smallest number, is that on the object.
constexpr const char* found_objects = R"sql(
with object as (
  select inspection, comparison, min(number) as finding from finding group by inspection, comparison, same_as
)
select o.inspection, coalesce(d.verdict, 'undecided'), coalesce(d.object, ''), count(*)
from object o left join decision d on d.id = (
  select max(id) from decision
  where inspection = o.inspection and comparison = o.comparison and finding = o.finding)
group by 1, 2, 3
)sql";

constexpr const char* marked_objects = R"sql(
select m.inspection, coalesce(d.verdict, 'undecided'), coalesce(d.object, ''), count(*)
from mark m left join mark_decision d on d.id = (
  select max(id) from mark_decision where inspection = m.inspection and mark = m.number)
group by 1, 2, 3
)sql";

class Tallies {
 public:
  Tallies(SQLite::Database& database, const InspectionFilter& filter) : database_(database) {
    for (const InspectionSummary& summary : summaries_of(database, filter))
      all_.push_back({summary.id,
                      summary.order.zone,
                      summary.created_at,
                      summary.closing ? summary.closing->closed_at : "",
                      0,
                      {},
                      {},
                      {}});
  }

  void count_comparisons() {
    SQLite::Statement row(database_, comparisons);
    while (row.executeStep())
      if (InspectionTally* const tally = find(row.getColumn(0)))
        tally->comparisons = static_cast<std::size_t>(row.getColumn(1).getInt64());
  }

  // @param query inspection, verdict, name and number of objects
  void count_objects(const char* query, VerdictCounts InspectionTally::*counts) {
    SQLite::Statement row(database_, query);
    while (row.executeStep()) {
      InspectionTally* const tally = find(row.getColumn(0));
      if (tally == nullptr) continue;
      VerdictCounts objects;
      objects.add(value_of<Verdict>(row.getColumn(1).getString()).value(),
                  static_cast<std::size_t>(row.getColumn(3).getInt64()));
      tally->*counts += objects;
      if (objects.any_debris() > 0)
        tally->debris_by_name[row.getColumn(2).getString()] += objects.any_debris();
    }
  }

  std::vector<InspectionTally> all() && { return std::move(all_); }

 private:
  // Null for an inspection that the filter leaves out.
  InspectionTally* find(std::int64_t id) {
    const auto newest_first = [](const InspectionTally& tally, std::int64_t wanted) {
      return tally.id > wanted;
    };
    const auto found = std::lower_bound(all_.begin(), all_.end(), id, newest_first);
    return found != all_.end() && found->id == id ? &*found : nullptr;
  }

  SQLite::Database& database_;
  std::vector<InspectionTally> all_;
};

}  // namespace

std::vector<InspectionTally> tallies_of(SQLite::Database& database, const InspectionFilter& filter) {
  Tallies tallies(database, filter);
  tallies.count_comparisons();
  tallies.count_objects(found_objects, &InspectionTally::found);
  tallies.count_objects(marked_objects, &InspectionTally::marked);
  return std::move(tallies).all();
}

}  // namespace rva
