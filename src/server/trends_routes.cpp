#include "core/intervals.hpp"
#include "core/json_object.hpp"
#include "report/trends.hpp"
#include "server/api.hpp"
#include "server/inspection_filter.hpp"

namespace rva {
namespace {

Json json_of(const VerdictCounts& counts) {
  return {{"removed", counts.removed},           {"left", counts.debris},
          {"unreachable", counts.unreachable},   {"installed", counts.installed},
          {"false_alarms", counts.false_alarms}, {"undecided", counts.undecided}};
}

Json ratio_json(std::size_t count, std::size_t trials, const Interval& interval) {
  return {{"value", static_cast<double>(count) / static_cast<double>(trials)},
          {"low", interval.low},
          {"high", interval.high}};
}

void add_trend(Json& json, const Trend& trend) {
  json["inspections"] = trend.inspections;
  json["closed"] = trend.closed;
  if (const auto hours = trend.median_hours()) json["median_hours"] = *hours;
  json["comparisons"] = trend.comparisons;
  json["found"] = json_of(trend.found);
  json["marked"] = json_of(trend.marked);
  const std::size_t false_alarms = trend.found.false_alarms;
  if (trend.comparisons > 0)
    json["false_alarms_per_comparison"] =
        ratio_json(false_alarms, trend.comparisons, rate_interval(false_alarms, trend.comparisons));
  if (trend.decided() > 0)
    json["false_alarm_share"] =
        ratio_json(false_alarms, trend.decided(), share_interval(false_alarms, trend.decided()));
  json["debris"] = Json::array();
  for (const auto& [name, objects] : trend.debris_by_name)
    json["debris"].push_back({{"name", name}, {"objects", objects}});
}

// @param key what the trends are by
Json list_of(const std::string& key, const std::map<std::string, Trend>& trends) {
  Json list = Json::array();
  for (const auto& [of, trend] : trends) {
    list.push_back({{key, of}});
    add_trend(list.back(), trend);
  }
  return list;
}

Json json_of(const Trends& trends) {
  Json json{{"sum", Json::object()},
            {"months", list_of("month", by_month(trends))},
            {"zones", list_of("zone", by_zone(trends))},
            {"zone_months", Json::array()}};
  add_trend(json["sum"], sum_of(trends));
  for (const auto& [of, trend] : trends) {
    json["zone_months"].push_back({{"zone", of.zone}, {"month", of.month}});
    add_trend(json["zone_months"].back(), trend);
  }
  return json;
}

}  // namespace

ApiResponse Api::get_trends(const Call& call) const {
  const InspectionFilter filter = filter_in(query_values(call.request.query));
  return {200, "application/json", json_text(json_of(trends_of(parts_.inspector.tallies(filter))))};
}

ApiResponse Api::get_trends_csv(const Call& call) const {
  const InspectionFilter filter = filter_in(query_values(call.request.query));
  return {200,
          "text/csv; charset=utf-8",
          csv_of(trends_of(parts_.inspector.tallies(filter))),
          {{"Content-Disposition", "attachment; filename=\"trends.csv\""}}};
}

}  // namespace rva
