#include "evaluate/report.hpp"

#include <fmt/format.h>

#include <string>

#include "core/intervals.hpp"
#include "evaluate/table.hpp"

namespace rva {
namespace {

bool is_small(const Target& target) { return target.kind == "collar-0.27" && target.distance_m <= 1.0; }

void add_small(const Target& target, std::size_t found, Tally& tally) {
  ++tally.small_targets;
  tally.small_found += found;
  if (!target.is_shown()) return;
  ++tally.small_shown_targets;
  tally.small_shown_found += found;
}

void add(const SimulatedInspection& inspection, const Result& result, Tally& tally) {
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
    tally.found_when_clean += result.found_when_clean[i] ? 1 : 0;
    if (target.is_shown()) {
      ++tally.shown_targets;
      tally.shown_found += found;
    }
    if (is_small(target)) add_small(target, found, tally);
    all = all && result.found[i];
  }
  if (all) ++tally.all_found;
}

}  // namespace

std::vector<Tally> tally(const std::vector<SimulatedInspection>& inspections) {
  std::vector<Tally> tallies;
  for (const SimulatedInspection& inspection : inspections) {
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
  std::vector<TableColumn> keys{{"frames"}, {"method"}, {"setting"}};
  std::vector<TableColumn> columns{{"false each, unchanged"}, {"false each, debris"}, {"all found"},
                                   {"visible debris found"},  {"by chance"},          {"of what depth shows"},
                                   {"0.27 in within 1 m"},    {"of what depth shows"}};
  for (const Tally& of : tallies) {
    add_row(keys, {std::to_string(of.frames), of.detector.method, fmt::format("{:g}", of.detector.setting)});
    add_row(columns,
            {stated_rate(of.false_when_clean, of.inspections),
             stated_rate(of.false_with_debris, of.inspections), stated_share(of.all_found, of.inspections),
             stated_share(of.found, of.targets), std::to_string(of.found_when_clean),
             stated_share(of.shown_found, of.shown_targets), stated_share(of.small_found, of.small_targets),
             stated_share(of.small_shown_found, of.small_shown_targets)});
  }
  return table_of(keys, columns);
}

}  // namespace rva
