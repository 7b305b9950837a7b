#include <fmt/format.h>

#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "core/intervals.hpp"
#include "evaluate/recorded_study.hpp"
#include "evaluate/table.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

constexpr int large_px = 120;

/// Counts of findings, and of targets in space that the first initial capture observed as free.
struct Counts {
  std::size_t comparisons = 0;
  std::size_t refused = 0;
  std::size_t false_findings = 0;
  std::size_t found = 0;
  std::size_t all = 0;
  std::size_t large_found = 0;
  std::size_t large = 0;

  void add(const RecordedScene& scene, const RecordedResult& result) {
    ++comparisons;
    refused += result.refused.empty() ? 0U : 1U;
    false_findings += result.false_findings;
    for (std::size_t i = 0; i < scene.targets.size(); ++i) {
      if (!scene.targets[i].seen_free) continue;
      const std::size_t one = result.found[i] ? 1 : 0;
      ++all;
      found += one;
      if (scene.targets[i].target.visible_px <= large_px) continue;
      ++large;
      large_found += one;
    }
  }
};

/// The row of the totals to which a result belongs: "one" for scenes with one initial capture, else the
/// number of captures used per side.
std::string kind_of(const RecordedScene& scene, const RecordedResult& result) {
  return scene.initial.size() == 1 ? "one" : std::to_string(result.captures);
}

/// The rows of the table.
struct ResultRows {
  std::vector<TableColumn> keys{{"scene"}, {"captures"}, {"allowed"}};
  std::vector<TableColumn> columns{
      {"false each"}, {"found of those over 120 px"}, {"all found"}, {"refused"}};

  void add(const std::string& scene, const std::string& captures, double allowed, const Counts& of) {
    add_row(keys, {scene, captures, fmt::format("{:g}", allowed)});
    add_row(columns, {stated_rate(of.false_findings, of.comparisons), stated_share(of.large_found, of.large),
                      stated_share(of.found, of.all), of.refused > 0 ? std::to_string(of.refused) : ""});
  }
};

void add_objects(std::string& table, const RecordedInspection& inspection) {
  for (std::size_t i = 0; i < inspection.scene.targets.size(); ++i) {
    const RecordedTarget& target = inspection.scene.targets[i];
    std::string marks;
    for (const RecordedResult& result : inspection.results) marks += result.found[i] ? " +" : " -";
    fmt::format_to(std::back_inserter(table), "{:28.28}  {:28.28} {:>6} px {:>5} {}\n", inspection.scene.name,
                   target.target.kind, target.target.visible_px, target.seen_free ? "free" : "", marks);
  }
}

Json json_of(const RecordedResult& result) {
  Json json{{"captures", result.captures},
            {"allowed", result.allowed},
            {"method", result.method},
            {"false_findings", result.false_findings},
            {"found", result.found}};
  if (!result.refused.empty()) json["refused"] = result.refused;
  if (result.error_mm) json["error_mm"] = *result.error_mm;
  if (result.error_deg) json["error_deg"] = *result.error_deg;
  return json;
}

Json json_of(const RecordedInspection& inspection) {
  Json json{{"scene", inspection.scene.name}, {"targets", Json::array()}, {"results", Json::array()}};
  for (const RecordedTarget& of : inspection.scene.targets)
    json["targets"].push_back({{"name", of.target.kind},
                               {"visible_px", of.target.visible_px},
                               {"distance_m", of.target.distance_m},
                               {"seen_free", of.seen_free}});
  for (const RecordedResult& result : inspection.results) json["results"].push_back(json_of(result));
  return json;
}

}  // namespace

std::string to_table(const std::vector<RecordedInspection>& inspections) {
  ResultRows rows;
  std::map<std::pair<std::string, double>, Counts> totals;
  for (const RecordedInspection& inspection : inspections) {
    for (const RecordedResult& result : inspection.results) {
      Counts counts;
      counts.add(inspection.scene, result);
      rows.add(inspection.scene.name, std::to_string(result.captures), result.allowed, counts);
      totals[{kind_of(inspection.scene, result), result.allowed}].add(inspection.scene, result);
    }
  }
  for (const auto& [key, counts] : totals)
    rows.add("all of", key.first == "one" ? "one" : key.first + " of many", key.second, counts);
  std::string table = table_of(rows.keys, rows.columns);
  table += "\nobjects, found (+) or not (-) in the order of the rows of their scene:\n";
  for (const RecordedInspection& inspection : inspections) add_objects(table, inspection);
  return table;
}

Json json_of(const std::vector<RecordedInspection>& inspections) {
  Json json{{"format", "rva-evaluation-recorded"}, {"version", 1}, {"inspections", Json::array()}};
  for (const RecordedInspection& inspection : inspections) json["inspections"].push_back(json_of(inspection));
  return json;
}

}  // namespace rva
