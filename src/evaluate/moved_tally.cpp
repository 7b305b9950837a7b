#include "evaluate/moved_tally.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "scene/debris/debris_catalogue.hpp"

namespace rva {
namespace {

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

}  // namespace rva
