#include "evaluate/moved_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "core/json_object.hpp"
#include "core/quantile.hpp"
#include "detect/calibrated/calibrated.hpp"
#include "detect/thesis/octree_detection.hpp"
#include "evaluate/intervals.hpp"
#include "evaluate/table.hpp"
#include "scene/debris/debris_catalogue.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

void add(const MovedInspection& inspection, const MovedResult& result, MovedTally& tally) {
  constexpr int large_px = 120;
  ++tally.inspections;
  tally.false_when_clean += result.false_when_clean;
  tally.false_with_debris += result.false_with_debris;
  tally.work_findings += result.work_findings;
  tally.trace_findings += result.trace_findings;
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
  std::vector<double> mm;   ///< of those that were trusted
  std::vector<double> deg;  ///< likewise
  std::size_t within = 0;   ///< 4 mm and 0.25 degrees
  std::size_t refused = 0;
  std::size_t trusted_and_wrong = 0;  ///< off by more than 20 mm or a degree
  std::vector<double> normalised;     ///< of those that state a covariance
  std::size_t as_claimed = 0;         ///< of these, within the 95 % that their covariance claims
};

// With six degrees of freedom.
constexpr double chi_squared_50 = 5.348;
constexpr double chi_squared_95 = 12.592;

void add(const MovedRegistration& one, Registrations& sum) {
  if (!one.doubt.empty()) {
    ++sum.refused;
    return;
  }
  sum.mm.push_back(one.error_mm);
  sum.deg.push_back(one.error_deg);
  sum.within += one.error_mm < 4.0 && one.error_deg < 0.25 ? 1 : 0;
  sum.trusted_and_wrong += one.error_mm > 20.0 || one.error_deg > 1.0 ? 1 : 0;
  if (!one.normalised) return;
  sum.normalised.push_back(*one.normalised);
  sum.as_claimed += *one.normalised <= chi_squared_95 ? 1 : 0;
}

/// By method and captures a side.
std::map<std::pair<std::string, int>, Registrations> registrations_of(
    const std::vector<MovedInspection>& inspections) {
  std::map<std::pair<std::string, int>, Registrations> all;
  for (const MovedInspection& inspection : inspections) {
    for (const MovedRegistration& one : inspection.registrations) add(one, all[{one.method, one.captures}]);
  }
  return all;
}

struct Share {
  std::size_t found = 0;
  std::size_t all = 0;
};

bool is_usual(const MovedResult& result) {
  return result.setting ==
         (result.method == "octree" ? OctreeOptions{}.cell_m : CalibratedOptions{}.false_findings);
}

// "0.4 to 0.6 m"
std::string distance_of(const MovedTarget& target) {
  constexpr double step_m = 0.2;
  const double from_m = step_m * std::floor(target.target.distance_m / step_m);
  return fmt::format("at {:.1f} to {:.1f} m", from_m, from_m + step_m);
}

/// By what a row is about (kind of debris, distance, light), method and captures a side.
using Shares = std::map<std::tuple<std::string, std::string, int>, Share>;

void add(const MovedInspection& inspection, const MovedResult& result, Shares& shares) {
  for (std::size_t i = 0; i < inspection.targets.size(); ++i) {
    const MovedTarget& target = inspection.targets[i];
    if (!target.counts()) continue;
    const std::string size = target.big ? "big" : "small";
    for (const std::string& row : {target.target.kind, fmt::format("{}, {}", size, distance_of(target)),
                                   fmt::format("{}, light {:g}", size, inspection.ambient),
                                   fmt::format("{}, {}", size, inspection.matcher)}) {
      Share& share = shares[{row, result.method, result.captures}];
      share.found += result.found[i] ? 1 : 0;
      ++share.all;
    }
  }
}

Shares shares_at_usual_setting(const std::vector<MovedInspection>& inspections) {
  Shares shares;
  for (const MovedInspection& inspection : inspections) {
    for (const MovedResult& result : inspection.results) {
      if (is_usual(result)) add(inspection, result, shares);
    }
  }
  return shares;
}

Json json_of(const Interval& interval) { return {interval.low, interval.high}; }

Json json_of(const MovedTally& of) {
  return {{"method", of.method},
          {"captures", of.captures},
          {"setting", of.setting},
          {"inspections", of.inspections},
          {"false_when_clean", of.false_when_clean},
          {"false_rate_95", json_of(rate_interval(of.false_when_clean, of.inspections))},
          {"false_with_debris", of.false_with_debris},
          {"work_findings", of.work_findings},
          {"trace_findings", of.trace_findings},
          {"targets", of.targets},
          {"found", of.found},
          {"found_share_95", json_of(share_interval(of.found, of.targets))},
          {"big", of.big},
          {"big_found", of.big_found},
          {"big_share_95", json_of(share_interval(of.big_found, of.big))},
          {"large", of.large},
          {"large_found", of.large_found}};
}

Json json_of(const MovedInspection& inspection) {
  Json json{{"seed", inspection.seed},         {"move_m", inspection.move_m},
            {"turn_deg", inspection.turn_deg}, {"matcher", inspection.matcher},
            {"ambient", inspection.ambient},   {"targets", Json::array()},
            {"results", Json::array()}};
  json["off_baseline_deg"] = inspection.off_baseline_deg;
  json["approaches"] = inspection.approaches;
  for (const MovedTarget& of : inspection.targets)
    json["targets"].push_back(Json{{"kind", of.target.kind},
                                   {"visible_px", of.target.visible_px},
                                   {"unhidden_px", of.target.unhidden_px},
                                   {"distance_m", of.target.distance_m},
                                   {"big", of.big},
                                   {"seen_free", of.seen_free}});
  for (const MovedRegistration& of : inspection.registrations) {
    Json& registration = json["registrations"].emplace_back(Json{{"method", of.method},
                                                                 {"captures", of.captures},
                                                                 {"error_mm", of.error_mm},
                                                                 {"error_deg", of.error_deg},
                                                                 {"doubt", of.doubt}});
    if (of.normalised) registration["normalised"] = *of.normalised;
  }
  for (const MovedResult& of : inspection.results)
    json["results"].push_back(Json{{"method", of.method},
                                   {"captures", of.captures},
                                   {"setting", of.setting},
                                   {"false_when_clean", of.false_when_clean},
                                   {"false_with_debris", of.false_with_debris},
                                   {"work_findings", of.work_findings},
                                   {"trace_findings", of.trace_findings},
                                   {"found", of.found}});
  return json;
}

MovedInspection inspection_from(const nlohmann::json& json) {
  MovedInspection inspection;
  json.at("seed").get_to(inspection.seed);
  json.at("move_m").get_to(inspection.move_m);
  json.at("turn_deg").get_to(inspection.turn_deg);
  json.at("matcher").get_to(inspection.matcher);
  json.at("ambient").get_to(inspection.ambient);
  inspection.off_baseline_deg = json.value("off_baseline_deg", 0.0);
  inspection.approaches = json.value("approaches", 1.0);
  for (const nlohmann::json& of : json.at("targets")) {
    MovedTarget target;
    of.at("kind").get_to(target.target.kind);
    of.at("visible_px").get_to(target.target.visible_px);
    of.at("unhidden_px").get_to(target.target.unhidden_px);
    of.at("distance_m").get_to(target.target.distance_m);
    of.at("big").get_to(target.big);
    of.at("seen_free").get_to(target.seen_free);
    inspection.targets.push_back(std::move(target));
  }
  for (const nlohmann::json& of : json.value("registrations", nlohmann::json::array())) {
    inspection.registrations.push_back({.method = of.at("method"),
                                        .captures = of.at("captures"),
                                        .error_mm = of.at("error_mm"),
                                        .error_deg = of.at("error_deg"),
                                        .doubt = of.at("doubt")});
    if (of.contains("normalised")) inspection.registrations.back().normalised = of.at("normalised");
  }
  for (const nlohmann::json& of : json.at("results")) {
    inspection.results.push_back({.method = of.at("method"),
                                  .captures = of.at("captures"),
                                  .setting = of.at("setting"),
                                  .false_when_clean = of.at("false_when_clean"),
                                  .false_with_debris = of.at("false_with_debris"),
                                  .work_findings = of.value("work_findings", std::size_t{0}),
                                  .trace_findings = of.value("trace_findings", std::size_t{0}),
                                  .found = of.at("found")});
    if (inspection.results.back().found.size() != inspection.targets.size())
      throw nlohmann::json::other_error::create(0, "found and targets differ in number", &of);
  }
  return inspection;
}

// The collars that count at a distance, of the k-th result of each inspection.
std::vector<DetectionTrial> trials_of(const std::vector<MovedInspection>& inspections, std::size_t k,
                                      double from_m, double to_m) {
  std::vector<DetectionTrial> trials;
  for (const MovedInspection& inspection : inspections) {
    for (std::size_t i = 0; i < inspection.targets.size(); ++i) {
      const MovedTarget& target = inspection.targets[i];
      const DebrisKind* const kind = find_debris_kind(target.target.kind);
      if (!target.counts() || kind == nullptr || !kind->name.starts_with("collar-")) continue;
      if (target.target.distance_m < from_m || target.target.distance_m >= to_m) continue;
      trials.push_back({kind->size_mm, inspection.results[k].found[i]});
    }
  }
  return trials;
}

// "a90 9.1 mm, a90/95 11.3 mm"
std::string stated_sizes(const std::optional<DetectionSizes>& sizes) {
  if (!sizes) return "no curve fits";
  return fmt::format("a90 {:.1f} mm, a90/95 {}", sizes->a90_mm,
                     sizes->a90_95_mm ? fmt::format("{:.1f} mm", *sizes->a90_95_mm) : "not proven");
}

// Of studies in which each pose was approached more than once.
std::string stated_return(const std::vector<MovedInspection>& inspections) {
  std::vector<double> off_deg;
  double approaches = 0.0;
  for (const MovedInspection& inspection : inspections) {
    off_deg.push_back(inspection.off_baseline_deg);
    approaches += inspection.approaches / static_cast<double>(inspections.size());
  }
  if (approaches <= 1.0) return "";
  return fmt::format(
      "poses: {:.1f} approaches each, {:.3f} degrees from the baseline's in the median inspection\n",
      approaches, quantile(off_deg, 0.5));
}

std::string table_of_tallies(const std::vector<MovedTally>& tallies) {
  std::vector<TableColumn> keys{{"method"}, {"captures"}, {"setting"}};
  std::vector<TableColumn> columns{{"false each, unchanged"},
                                   {"false each, debris"},
                                   {"big debris found"},
                                   {"of that over 120 px"},
                                   {"all debris found"}};
  for (const MovedTally& of : tallies) {
    add_row(keys, {of.method, std::to_string(of.captures), fmt::format("{:g}", of.setting)});
    add_row(columns, {stated_rate(of.false_when_clean, of.inspections),
                      stated_rate(of.false_with_debris, of.inspections), stated_share(of.big_found, of.big),
                      stated_share(of.large_found, of.large), stated_share(of.found, of.targets)});
  }
  return table_of(keys, columns);
}

// What the registrations of a method with so many captures a side were worth. Sorts their errors.
std::string stated(const std::string& method, int captures, Registrations& of) {
  const std::string head = fmt::format("{:8}  {:>8}  ", method, captures);
  if (of.mm.empty()) return fmt::format("{}registration: all {} refused\n", head, of.refused);
  std::string text = fmt::format(
      "{}registration: median {:.2f} mm, {:.3f} degrees\n"
      "{:20}{} of {} within 4 mm and 0.25 degrees; {} refused; {} trusted and wrong\n",
      head, quantile(of.mm, 0.5), quantile(of.deg, 0.5), "", of.within, of.mm.size() + of.refused, of.refused,
      of.trusted_and_wrong);
  if (of.normalised.empty()) return text;
  return text + fmt::format(
                    "{:20}errors within the 95 % of the stated covariance: {}\n"
                    "{:20}median of their squares in deviations: {:.1f}, where {:.1f} is expected\n",
                    "", stated_share(of.as_claimed, of.normalised.size()), "", quantile(of.normalised, 0.5),
                    chi_squared_50);
}

Json json_of(const CollarDetection& of) {
  Json json{{"method", of.method}, {"captures", of.captures}, {"setting", of.setting}, {"from_m", of.from_m},
            {"to_m", of.to_m},     {"collars", of.collars},   {"found", of.found}};
  if (!of.sizes) return json;
  json["a50_mm"] = of.sizes->a50_mm;
  json["a90_mm"] = of.sizes->a90_mm;
  if (of.sizes->a90_95_mm) json["a90_95_mm"] = *of.sizes->a90_95_mm;
  return json;
}

}  // namespace

std::vector<MovedTally> tally(const std::vector<MovedInspection>& inspections) {
  std::vector<MovedTally> tallies;
  for (const MovedInspection& inspection : inspections) {
    if (tallies.empty()) {
      for (const MovedResult& result : inspection.results) {
        MovedTally empty;
        empty.method = result.method;
        empty.captures = result.captures;
        empty.setting = result.setting;
        tallies.push_back(empty);
      }
    }
    for (std::size_t i = 0; i < tallies.size(); ++i) add(inspection, inspection.results[i], tallies[i]);
  }
  return tallies;
}

std::vector<CollarDetection> collar_detection(const std::vector<MovedInspection>& inspections) {
  constexpr std::array edges_m{0.0, 0.4, 0.6, 1.0};
  std::vector<CollarDetection> all;
  if (inspections.empty()) return all;
  for (std::size_t k = 0; k < inspections.front().results.size(); ++k) {
    const MovedResult& result = inspections.front().results[k];
    for (std::size_t i = 0; i + 1 < edges_m.size(); ++i) {
      CollarDetection one{.method = result.method,
                          .captures = result.captures,
                          .setting = result.setting,
                          .from_m = edges_m[i],
                          .to_m = edges_m[i + 1],
                          .sizes = {}};
      const std::vector<DetectionTrial> trials = trials_of(inspections, k, one.from_m, one.to_m);
      one.collars = trials.size();
      one.found = static_cast<std::size_t>(std::ranges::count_if(trials, &DetectionTrial::found));
      one.sizes = fit_detection_sizes(trials);
      all.push_back(std::move(one));
    }
  }
  return all;
}

std::string to_table(const std::vector<MovedInspection>& inspections) {
  std::string text = table_of_tallies(tally(inspections)) + stated_return(inspections);
  for (auto& [key, of] : registrations_of(inspections)) text += stated(key.first, key.second, of);
  for (const auto& [key, share] : shares_at_usual_setting(inspections)) {
    const auto& [kind, method, captures] = key;
    fmt::format_to(std::back_inserter(text), "{:8}  {:>8}  {:26} {}\n", method, captures, kind,
                   stated_share(share.found, share.all));
  }
  for (const CollarDetection& of : collar_detection(inspections)) {
    if (of.collars == 0) continue;
    fmt::format_to(std::back_inserter(text), "{:8}  {:>8}  {:>7}  collars at {:.1f} to {:.1f} m: {}\n",
                   of.method, of.captures, fmt::format("{:g}", of.setting), of.from_m, of.to_m,
                   stated_share(of.found, of.collars));
    fmt::format_to(std::back_inserter(text), "{:29}{}\n", "", stated_sizes(of.sizes));
  }
  return text;
}

Json json_of(const std::vector<MovedInspection>& inspections, const std::string& arguments) {
  Json json{{"format", "rva-evaluation-moved"}, {"version", 2}, {"arguments", arguments}};
  json["tallies"] = Json::array();
  for (const MovedTally& of : tally(inspections)) json["tallies"].push_back(json_of(of));
  json["probability_of_detection"] = Json::array();
  for (const CollarDetection& of : collar_detection(inspections))
    json["probability_of_detection"].push_back(json_of(of));
  json["inspections"] = Json::array();
  for (const MovedInspection& inspection : inspections) json["inspections"].push_back(json_of(inspection));
  return json;
}

std::vector<MovedInspection> moved_inspections_from_json(const std::string& text, const std::string& source,
                                                         const std::string& arguments) {
  const nlohmann::json json = parse_json(text, source);
  try {
    if (json.at("arguments").get<std::string>() != arguments)
      throw OptionError("resume", "the evaluation that is there was begun with other options",
                        "give the options that it was begun with, or another folder");
    std::vector<MovedInspection> inspections;
    for (const nlohmann::json& one : json.at("inspections")) inspections.push_back(inspection_from(one));
    return inspections;
  } catch (const nlohmann::json::exception& exception) {
    throw Error(source, std::string("is no evaluation to go on with: ") + exception.what(),
                "choose another folder");
  }
}

}  // namespace rva
