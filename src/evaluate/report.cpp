#include "evaluate/report.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "evaluate/intervals.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

bool is_small(const Target& target) { return target.kind == "collar-0.27" && target.distance_m <= 1.0; }

void add(const Inspection& inspection, const Result& result, Tally& tally) {
  ++tally.inspections;
  tally.false_when_clean += result.false_when_clean;
  tally.false_with_debris += result.false_with_debris;
  bool all = true;
  for (std::size_t i = 0; i < inspection.targets.size(); ++i) {
    const Target& target = inspection.targets[i];
    if (!target.is_visible()) continue;
    const std::size_t found = result.found[i] ? 1 : 0;
    ++tally.targets;
    tally.found += found;
    if (is_small(target)) ++tally.small_targets;
    if (is_small(target)) tally.small_found += found;
    all = all && result.found[i];
  }
  if (all) ++tally.all_found;
}

std::string share(std::size_t successes, std::size_t trials) {
  if (trials == 0) return "-";
  const Interval interval = share_interval(successes, trials);
  return fmt::format("{}/{} {:.0f} % ({:.0f}-{:.0f})", successes, trials,
                     100.0 * static_cast<double>(successes) / static_cast<double>(trials),
                     100.0 * interval.low, 100.0 * interval.high);
}

std::string rate(std::size_t count, std::size_t trials) {
  const Interval interval = rate_interval(count, trials);
  return fmt::format("{:.3g} ({:.2g}-{:.2g})", static_cast<double>(count) / static_cast<double>(trials),
                     interval.low, interval.high);
}

Json to_json_value(const Target& target) {
  return {{"kind", target.kind},
          {"visible_px", target.visible_px},
          {"unhidden_px", target.unhidden_px},
          {"distance_m", target.distance_m}};
}

Json to_json_value(const Result& result) {
  return {{"frames", result.frames},
          {"method", result.detector.method},
          {"setting", result.detector.setting},
          {"false_when_clean", result.false_when_clean},
          {"false_with_debris", result.false_with_debris},
          {"found", result.found}};
}

Json to_json_value(const Tally& tally) {
  const auto interval = [](const Interval& of) { return Json{of.low, of.high}; };
  return {{"frames", tally.frames},
          {"method", tally.detector.method},
          {"setting", tally.detector.setting},
          {"inspections", tally.inspections},
          {"false_when_clean", tally.false_when_clean},
          {"false_rate_95", interval(rate_interval(tally.false_when_clean, tally.inspections))},
          {"false_with_debris", tally.false_with_debris},
          {"found", tally.found},
          {"targets", tally.targets},
          {"found_share_95", interval(share_interval(tally.found, tally.targets))},
          {"small_found", tally.small_found},
          {"small_targets", tally.small_targets},
          {"small_share_95", interval(share_interval(tally.small_found, tally.small_targets))},
          {"all_found", tally.all_found}};
}

}  // namespace

std::vector<Tally> tally(const std::vector<Inspection>& inspections) {
  std::vector<Tally> tallies;
  for (const Inspection& inspection : inspections) {
    if (tallies.empty()) {
      for (const Result& result : inspection.results) {
        Tally empty;
        empty.frames = result.frames;
        empty.detector = result.detector;
        tallies.push_back(empty);
      }
    }
    for (std::size_t i = 0; i < tallies.size(); ++i) add(inspection, inspection.results[i], tallies[i]);
  }
  return tallies;
}

std::string to_table(const std::vector<Tally>& tallies) {
  std::string table = fmt::format("{:>6}  {:10} {:>7}  {:>22}  {:>22}  {:>24}  {:>24}  {:>22}\n", "frames",
                                  "method", "setting", "false each, unchanged", "false each, debris",
                                  "visible debris found", "0.27 in within 1 m", "all found");
  for (const Tally& tally : tallies) {
    fmt::format_to(std::back_inserter(table), "{:>6}  {:10} {:>7g}  {:>22}  {:>22}  {:>24}  {:>24}  {:>22}\n",
                   tally.frames, tally.detector.method, tally.detector.setting,
                   rate(tally.false_when_clean, tally.inspections),
                   rate(tally.false_with_debris, tally.inspections), share(tally.found, tally.targets),
                   share(tally.small_found, tally.small_targets), share(tally.all_found, tally.inspections));
  }
  return table;
}

std::string to_json(const std::vector<Inspection>& inspections, const std::vector<Tally>& tallies) {
  Json json{{"format", "rva-evaluation"}, {"version", 1}};
  json["tallies"] = Json::array();
  for (const Tally& of : tallies) json["tallies"].push_back(to_json_value(of));
  json["inspections"] = Json::array();
  for (const Inspection& inspection : inspections) {
    Json one{{"seed", inspection.seed}, {"targets", Json::array()}, {"results", Json::array()}};
    for (const Target& target : inspection.targets) one["targets"].push_back(to_json_value(target));
    for (const Result& result : inspection.results) one["results"].push_back(to_json_value(result));
    json["inspections"].push_back(one);
  }
  return json.dump(1) + "\n";
}

}  // namespace rva
