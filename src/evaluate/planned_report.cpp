#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/intervals.hpp"
#include "evaluate/planned_study.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const PlannedResult& result) {
  return {{"missing_reported", result.missing_reported},
          {"lost_reported", result.lost_reported},
          {"grouped", result.grouped},
          {"others", result.others},
          {"not_inspected", result.not_inspected}};
}

void add_row(std::string& table, std::string_view plan, const std::vector<PlannedInspection>& inspections,
             PlannedResult PlannedInspection::*of) {
  const auto count = [&](const auto& counts) {
    return static_cast<std::size_t>(std::ranges::count_if(
        inspections, [&](const PlannedInspection& inspection) { return counts(inspection.*of); }));
  };
  std::size_t grouped = 0;
  std::size_t installed = 0;
  for (const PlannedInspection& inspection : inspections) {
    grouped += static_cast<std::size_t>((inspection.*of).grouped);
    installed += static_cast<std::size_t>(inspection.parts - 1);
  }
  const auto share = [&](std::size_t successes) { return stated_share(successes, inspections.size()); };
  fmt::format_to(std::back_inserter(table), "{:12}  {:>26}  {:>26}  {:>26}  {:>26}  {:>14}\n", plan,
                 share(count([](const PlannedResult& result) { return result.missing_reported; })),
                 share(count([](const PlannedResult& result) { return result.lost_reported; })),
                 share(count([](const PlannedResult& result) {
                   return result.missing_reported && result.lost_reported;
                 })),
                 share(count([](const PlannedResult& result) { return result.others <= 1; })),
                 fmt::format("{}/{}", grouped, installed));
}

}  // namespace

std::string to_table(const std::vector<PlannedInspection>& inspections) {
  std::string table = fmt::format("{:12}  {:>26}  {:>26}  {:>26}  {:>26}  {:>14}\n", "plan", "missing part",
                                  "lost object", "both", "at most 1 other", "grouped");
  add_row(table, "with places", inspections, &PlannedInspection::with_places);
  add_row(table, "by count", inspections, &PlannedInspection::by_count);
  return table;
}

Json json_of(const std::vector<PlannedInspection>& inspections) {
  Json json{{"format", "rva-evaluation-planned"}, {"version", 1}, {"inspections", Json::array()}};
  for (const PlannedInspection& inspection : inspections)
    json["inspections"].push_back({{"seed", inspection.seed},
                                   {"parts", inspection.parts},
                                   {"findings", inspection.findings},
                                   {"with_places", json_of(inspection.with_places)},
                                   {"by_count", json_of(inspection.by_count)}});
  return json;
}

}  // namespace rva
