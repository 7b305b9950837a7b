#include "store/summary_rows.hpp"

#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <utility>

namespace rva {
namespace {

// `compared_whole` and `undecided` must match stage_of() and is_settled().
constexpr const char* summaries = R"sql(
select i.id, i.aircraft, i.zone, i.work_order, i.person, i.created_at,
  a.taken_at, a.person, a.base, a.round,
  b.taken_at, b.person, b.base, b.round,
  c.number, c.compared_at, c.folder,
  (select count(*) from finding f where f.inspection = i.id and f.comparison = i.comparison),
  (select count(*) from finding f where f.inspection = i.id and f.comparison = i.comparison and coalesce(
    (select verdict from decision d
     where d.inspection = f.inspection and d.comparison = f.comparison and d.finding = f.number
     order by d.id desc limit 1), 'second-look') = 'second-look') as undecided,
  exists (select 1 from compared_view v where v.inspection = i.id)
    and (select count(*) from compared_view v where v.inspection = i.id)
      = (select count(*) from view w where w.inspection = i.id) as compared_whole
from inspection i
left join side a on a.inspection = i.id and a.side = 'initial' and a.round =
  (select max(round) from side where inspection = i.id and side = 'initial' and taken_at is not null)
left join side b on b.inspection = i.id and b.side = 'final' and b.round =
  (select max(round) from side where inspection = i.id and side = 'final' and taken_at is not null)
left join comparison c on c.inspection = i.id and c.number = i.comparison
order by i.id desc
)sql";

std::optional<TakenSide> side_from(SQLite::Statement& row, int first) {
  if (row.getColumn(first).isNull()) return std::nullopt;
  return TakenSide{.taken_at = row.getColumn(first),
                   .person = row.getColumn(first + 1),
                   .base = row.getColumn(first + 2),
                   .round = row.getColumn(first + 3)};
}

Stage stage_from(const InspectionSummary& summary, bool compared_whole) {
  if (!summary.initial) return Stage::baseline;
  if (!summary.comparison || !compared_whole) return Stage::work;
  return summary.undecided == 0 ? Stage::done : Stage::review;
}

}  // namespace

std::vector<InspectionSummary> summaries_of(SQLite::Database& database) {
  SQLite::Statement row(database, summaries);
  std::vector<InspectionSummary> all;
  while (row.executeStep()) {
    InspectionSummary summary;
    summary.id = row.getColumn(0);
    summary.order = {.aircraft = row.getColumn(1),
                     .zone = row.getColumn(2),
                     .work_order = row.getColumn(3),
                     .person = row.getColumn(4)};
    summary.created_at = row.getColumn(5).getString();
    summary.initial = side_from(row, 6);
    summary.final = side_from(row, 10);
    if (!row.getColumn(14).isNull())
      summary.comparison = RecordedComparison{row.getColumn(14), row.getColumn(15), row.getColumn(16)};
    summary.findings = static_cast<std::size_t>(row.getColumn(17).getInt64());
    summary.undecided = static_cast<std::size_t>(row.getColumn(18).getInt64());
    summary.stage = stage_from(summary, row.getColumn(19).getInt() != 0);
    all.push_back(std::move(summary));
  }
  return all;
}

}  // namespace rva
