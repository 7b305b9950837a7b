#include "store/summary_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>

namespace rva {
namespace {

// `stage` and `undecided` must match stage_of() and is_settled(). The stage is computed for the rows alone
// that the other conditions leave, and those are tried newest first until there are enough.
constexpr const char* summaries = R"sql(
select i.id, i.aircraft, i.zone, i.work_order, i.person, i.created_at,
  a.taken_at, a.person, a.base, a.round,
  b.taken_at, b.person, b.base, b.round,
  c.number, c.compared_at, c.folder, c.final_round,
  (select count(*) from finding f where f.inspection = i.id and f.comparison = i.comparison)
    + (select count(*) from mark m where m.inspection = i.id),
  (select count(*) from finding f where f.inspection = i.id and f.comparison = i.comparison and coalesce(
    (select verdict from decision d
     where d.inspection = f.inspection and d.comparison = f.comparison and d.finding = f.number
     order by d.id desc limit 1), 'second-look') in ('second-look', 'debris', 'undecided'))
    + (select count(*) from mark m where m.inspection = i.id and coalesce(
    (select verdict from mark_decision d where d.inspection = m.inspection and d.mark = m.number
     order by d.id desc limit 1), 'second-look') in ('second-look', 'debris', 'undecided')) as undecided,
  case
    when k.inspection is not null then 'done'
    when a.taken_at is null then 'baseline'
    when c.number is null
      or not exists (select 1 from compared_view v where v.inspection = i.id and v.comparison = i.comparison)
      or (select count(*) from compared_view v where v.inspection = i.id and v.comparison = i.comparison)
        <> (select count(*) from view w where w.inspection = i.id) then 'work'
    else 'review'
  end as stage,
  k.comparison, k.person, k.note, k.closed_at
)sql";

// The searched texts are read first, in the order of the list, since nothing else is as fast to rule out.
constexpr const char* of_all = "from inspection i";
constexpr const char* of_those_with_words = "from searched s cross join inspection i on i.id = s.inspection";

constexpr const char* conditions = R"sql(
left join closing k on k.inspection = i.id
left join side a on a.inspection = i.id and a.side = 'initial' and a.round =
  (select max(round) from side where inspection = i.id and side = 'initial' and taken_at is not null)
left join side b on b.inspection = i.id and b.side = 'final' and b.round =
  (select max(round) from side where inspection = i.id and side = 'final' and taken_at is not null)
left join comparison c on c.inspection = i.id and c.number = i.comparison
where (?1 = 0 or i.id < ?1) and i.created_at >= ?2 and (?3 = '' or i.created_at < ?3)
  and (?4 = '' or (?4 = 'done') = (k.inspection is not null))
  and (?4 = '' or stage = ?4)
)sql";

constexpr const char* newest_first = " order by i.id desc limit ?5";
constexpr const char* newest_with_words_first = " order by s.inspection desc limit ?5";

// The words of a text as patterns of LIKE that match wherever the word occurs.
std::vector<std::string> patterns_of(const std::string& text) {
  std::vector<std::string> patterns;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    std::string pattern = "%";
    for (const char c : word) {
      if (c == '%' || c == '_' || c == '\\') pattern += '\\';
      pattern += c;
    }
    patterns.push_back(pattern + "%");
  }
  return patterns;
}

std::optional<TakenSide> side_from(SQLite::Statement& row, int first) {
  if (row.getColumn(first).isNull()) return std::nullopt;
  return TakenSide{.taken_at = row.getColumn(first),
                   .person = row.getColumn(first + 1),
                   .base = row.getColumn(first + 2),
                   .round = row.getColumn(first + 3)};
}

// The parameters of words follow the numbered ones.
constexpr int first_word = 6;

std::string query_for(std::size_t words) {
  if (words == 0) return fmt::format("{}{}{}{}", summaries, of_all, conditions, newest_first);
  std::string query = fmt::format("{}{}{}", summaries, of_those_with_words, conditions);
  for (std::size_t k = 0; k < words; ++k)
    query += fmt::format(" and s.text like ?{} escape '\\'", first_word + static_cast<int>(k));
  return query + newest_with_words_first;
}

void bind_filter(SQLite::Statement& query, const InspectionFilter& filter,
                 const std::vector<std::string>& patterns) {
  constexpr std::int64_t all = -1;
  query.bind(1, filter.before);
  query.bind(2, filter.from);
  query.bind(3, filter.until);
  query.bind(4, filter.stage ? std::string(name_of(*filter.stage)) : "");
  query.bind(5, filter.most == 0 ? all : static_cast<std::int64_t>(filter.most));
  for (std::size_t k = 0; k < patterns.size(); ++k) query.bind(first_word + static_cast<int>(k), patterns[k]);
}

}  // namespace

std::vector<InspectionSummary> summaries_of(SQLite::Database& database, const InspectionFilter& filter) {
  const std::vector<std::string> patterns = patterns_of(filter.text);
  SQLite::Statement row(database, query_for(patterns.size()));
  bind_filter(row, filter, patterns);
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
      summary.comparison =
          RecordedComparison{row.getColumn(14), row.getColumn(15), row.getColumn(16), row.getColumn(17)};
    summary.findings = static_cast<std::size_t>(row.getColumn(18).getInt64());
    summary.undecided = static_cast<std::size_t>(row.getColumn(19).getInt64());
    summary.stage = value_of<Stage>(row.getColumn(20).getString()).value_or(Stage::review);
    if (!row.getColumn(21).isNull())
      summary.closing = Closing{row.getColumn(21), row.getColumn(22), row.getColumn(23), row.getColumn(24)};
    all.push_back(std::move(summary));
  }
  return all;
}

}  // namespace rva
