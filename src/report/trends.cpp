#include "report/trends.hpp"

#include "core/date_time.hpp"
#include "core/quantile.hpp"

namespace rva {
namespace {

// Empty where a time is none, or where the clock was set back in between.
std::optional<double> hours_between(const std::string& begun_at, const std::string& closed_at) {
  constexpr double ns_per_hour = 3.6e12;
  const auto begun_ns = ns_since_1970(begun_at);
  const auto closed_ns = ns_since_1970(closed_at);
  if (!begun_ns || !closed_ns || *closed_ns < *begun_ns) return std::nullopt;
  return static_cast<double>(*closed_ns - *begun_ns) / ns_per_hour;
}

void add(VerdictCounts& sum, const VerdictCounts& more) {
  sum.debris += more.debris;
  sum.removed += more.removed;
  sum.unreachable += more.unreachable;
  sum.installed += more.installed;
  sum.false_alarms += more.false_alarms;
  sum.undecided += more.undecided;
}

}  // namespace

std::optional<double> Trend::median_hours() const {
  std::vector<double> sorted = hours;
  return sorted.empty() ? std::nullopt : std::optional(quantile(sorted, 0.5));
}

void add_to(Trends& trends, const InspectionHistory& history) {
  const Inspection& inspection = history.inspection;
  constexpr std::size_t month_length = 7;
  Trend& trend = trends[{inspection.order.zone, inspection.created_at.substr(0, month_length)}];
  ++trend.inspections;
  trend.comparisons += history.rounds.size();
  for (const ComparedRound& round : history.rounds) add(trend.found, verdicts_of(round.findings));
  for (const MarkedFinding& marked : inspection.marked) trend.marked.count(marked.decision);
  if (!inspection.closing) return;
  ++trend.closed;
  if (const auto hours = hours_between(inspection.created_at, inspection.closing->closed_at))
    trend.hours.push_back(*hours);
}

Trend sum_of(const Trends& trends) {
  Trend sum;
  for (const auto& [of, trend] : trends) {
    sum.inspections += trend.inspections;
    sum.closed += trend.closed;
    sum.comparisons += trend.comparisons;
    add(sum.found, trend.found);
    add(sum.marked, trend.marked);
    sum.hours.insert(sum.hours.end(), trend.hours.begin(), trend.hours.end());
  }
  return sum;
}

}  // namespace rva
