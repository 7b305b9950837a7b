#include "evaluate/moved_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "core/quantile.hpp"
#include "evaluate/intervals.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

void add(const MovedInspection& inspection, const MovedResult& result, MovedTally& tally) {
  constexpr int large_px = 120;
  ++tally.inspections;
  tally.false_when_clean += result.false_when_clean;
  tally.false_with_debris += result.false_with_debris;
  for (std::size_t i = 0; i < inspection.targets.size(); ++i) {
    const MovedTarget& target = inspection.targets[i];
    if (!target.counts()) continue;
    const std::size_t found = result.found[i] ? 1 : 0;
    ++tally.targets;
    tally.found += found;
    if (!target.big) continue;
    ++tally.big;
    tally.big_found += found;
    if (target.target.visible_px <= large_px) continue;
    ++tally.large;
    tally.large_found += found;
  }
}

/// Of all inspections with so many captures a side.
struct Registrations {
  std::vector<double> mm;
  std::vector<double> deg;
  std::size_t within = 0;  ///< 4 mm and 0.25 degrees
  std::size_t refused = 0;
  std::size_t trusted_and_wrong = 0;  ///< off by more than 20 mm or a degree
};

std::map<int, Registrations> registrations_of(const std::vector<MovedInspection>& inspections) {
  std::map<int, Registrations> all;
  for (const MovedInspection& inspection : inspections) {
    for (const MovedRegistration& one : inspection.registrations) {
      Registrations& sum = all[one.captures];
      sum.mm.push_back(one.error_mm);
      sum.deg.push_back(one.error_deg);
      sum.within += one.error_mm < 4.0 && one.error_deg < 0.25 ? 1 : 0;
      sum.refused += one.doubt.empty() ? 0 : 1;
      sum.trusted_and_wrong += one.doubt.empty() && (one.error_mm > 20.0 || one.error_deg > 1.0) ? 1 : 0;
    }
  }
  return all;
}

Json to_json_value(const MovedInspection& inspection) {
  Json json{{"seed", inspection.seed}, {"move_m", inspection.move_m}, {"turn_deg", inspection.turn_deg}};
  for (const MovedTarget& of : inspection.targets)
    json["targets"].push_back(Json{{"kind", of.target.kind},
                                   {"visible_px", of.target.visible_px},
                                   {"unhidden_px", of.target.unhidden_px},
                                   {"distance_m", of.target.distance_m},
                                   {"big", of.big},
                                   {"seen_free", of.seen_free}});
  for (const MovedRegistration& of : inspection.registrations)
    json["registrations"].push_back(Json{{"captures", of.captures},
                                         {"error_mm", of.error_mm},
                                         {"error_deg", of.error_deg},
                                         {"doubt", of.doubt}});
  for (const MovedResult& of : inspection.results)
    json["results"].push_back(Json{{"captures", of.captures},
                                   {"allowed", of.allowed},
                                   {"false_when_clean", of.false_when_clean},
                                   {"false_with_debris", of.false_with_debris},
                                   {"found", of.found}});
  return json;
}

}  // namespace

std::vector<MovedTally> tally(const std::vector<MovedInspection>& inspections) {
  std::vector<MovedTally> tallies;
  for (const MovedInspection& inspection : inspections) {
    if (tallies.empty()) {
      for (const MovedResult& result : inspection.results) {
        MovedTally empty;
        empty.captures = result.captures;
        empty.allowed = result.allowed;
        tallies.push_back(empty);
      }
    }
    for (std::size_t i = 0; i < tallies.size(); ++i) add(inspection, inspection.results[i], tallies[i]);
  }
  return tallies;
}

std::string to_table(const std::vector<MovedInspection>& inspections) {
  constexpr auto line = "{:>8}  {:>7}  {:>22}  {:>19}  {:>24}  {:>24}  {:>24}\n";
  std::string table = fmt::format(line, "captures", "allowed", "false each, unchanged", "false each, debris",
                                  "big debris found", "of that over 120 px", "all debris found");
  for (const MovedTally& of : tally(inspections)) {
    fmt::format_to(std::back_inserter(table), line, of.captures, fmt::format("{:g}", of.allowed),
                   stated_rate(of.false_when_clean, of.inspections),
                   stated_rate(of.false_with_debris, of.inspections), stated_share(of.big_found, of.big),
                   stated_share(of.large_found, of.large), stated_share(of.found, of.targets));
  }
  for (auto& [captures, of] : registrations_of(inspections)) {
    fmt::format_to(std::back_inserter(table),
                   "{:>8}  registration: median {:.2f} mm, {:.3f} degrees; {} of {} within 4 mm and 0.25 "
                   "degrees; {} refused; {} trusted and wrong\n",
                   captures, quantile(of.mm, 0.5), quantile(of.deg, 0.5), of.within, of.mm.size(), of.refused,
                   of.trusted_and_wrong);
  }
  return table;
}

std::string to_json(const std::vector<MovedInspection>& inspections) {
  Json json{{"format", "rva-evaluation-moved"}, {"version", 1}};
  json["inspections"] = Json::array();
  for (const MovedInspection& inspection : inspections)
    json["inspections"].push_back(to_json_value(inspection));
  return json.dump(1) + "\n";
}

}  // namespace rva
