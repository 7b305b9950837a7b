#include "report/trends.hpp"

#include <fmt/format.h>

#include "core/csv_row.hpp"
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

Trend trend_of(const InspectionTally& tally) {
  Trend trend{.inspections = 1,
              .closed = tally.closed_at.empty() ? 0U : 1U,
              .comparisons = tally.comparisons,
              .found = tally.found,
              .marked = tally.marked,
              .debris_by_name = tally.debris_by_name,
              .hours = {}};
  if (const auto hours = hours_between(tally.created_at, tally.closed_at)) trend.hours.push_back(*hours);
  return trend;
}

}  // namespace

std::optional<double> Trend::median_hours() const {
  std::vector<double> sorted = hours;
  return sorted.empty() ? std::nullopt : std::optional(quantile(sorted, 0.5));
}

Trend& Trend::operator+=(const Trend& more) {
  inspections += more.inspections;
  closed += more.closed;
  comparisons += more.comparisons;
  found += more.found;
  marked += more.marked;
  for (const auto& [name, objects] : more.debris_by_name) debris_by_name[name] += objects;
  hours.insert(hours.end(), more.hours.begin(), more.hours.end());
  return *this;
}

Trends trends_of(const std::vector<InspectionTally>& tallies) {
  constexpr std::size_t month_length = 7;
  Trends trends;
  for (const InspectionTally& tally : tallies)
    trends[{tally.zone, tally.created_at.substr(0, month_length)}] += trend_of(tally);
  return trends;
}

Trend sum_of(const Trends& trends) {
  Trend sum;
  for (const auto& [of, trend] : trends) sum += trend;
  return sum;
}

std::map<std::string, Trend> by_month(const Trends& trends) {
  std::map<std::string, Trend> months;
  for (const auto& [of, trend] : trends) months[of.month] += trend;
  return months;
}

std::map<std::string, Trend> by_zone(const Trends& trends) {
  std::map<std::string, Trend> zones;
  for (const auto& [of, trend] : trends) zones[of.zone] += trend;
  return zones;
}

std::string csv_of(const Trends& trends) {
  std::string csv = csv_row({"zone", "month", "inspections", "closed", "median_hours", "comparisons",
                             "debris_removed", "debris_left", "debris_unreachable", "installed_work",
                             "false_alarms", "undecided", "marked_debris", "marked_other"});
  for (const auto& [of, trend] : trends) {
    std::vector<std::string> row{of.zone, of.month};
    const auto add = [&](std::size_t count) { row.push_back(std::to_string(count)); };
    add(trend.inspections);
    add(trend.closed);
    const std::optional<double> hours = trend.median_hours();
    row.push_back(hours ? fmt::format("{:.3f}", *hours) : "");
    for (const std::size_t count :
         {trend.comparisons, trend.found.removed, trend.found.debris, trend.found.unreachable,
          trend.found.installed, trend.found.false_alarms, trend.found.undecided, trend.marked.any_debris(),
          trend.marked.all() - trend.marked.any_debris()})
      add(count);
    csv += csv_row(row);
  }
  return csv;
}

}  // namespace rva
