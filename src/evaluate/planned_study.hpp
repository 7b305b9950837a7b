// Evaluation of planned work: whether one missing part and one lost object show among many planned changes.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "evaluate/study.hpp"

namespace rva {

/// How one plan grouped the findings of a bay.
struct PlannedResult {
  bool missing_reported = false;  ///< the missing part is stated as missing
  bool lost_reported = false;     ///< a finding or a piece of one at the lost object is not grouped
  int grouped = 0;                ///< parts that were found
  int others = 0;  ///< not grouped, but not of the lost object; and parts stated as missing that are there
  int not_inspected = 0;  ///< parts that were not found where the view was not inspected
};

/// One simulated inspection after planned work.
struct PlannedInspection {
  std::uint64_t seed = 0;     ///< determines everything random
  int parts = 0;              ///< number of planned parts
  std::size_t findings = 0;   ///< of the comparison
  PlannedResult with_places;  ///< by a plan with the place of each part
  PlannedResult by_count;     ///< by a plan with areas and numbers alone
};

/// Runs inspections one after the other: random_planned_bay(), 4 captures of 10 frames a side by the robot
/// that returns to rest, compared as `rva detect --plan` does.
/// @param options inspections, first seed and sensor; the others have no effect
/// @throws UsageError for options out of range; Error from the captures; Interrupted
[[nodiscard]] std::vector<PlannedInspection> run_planned_study(const StudyOptions& options,
                                                               const Progress& progress);

/// A table with a row for each kind of plan, with intervals of 95 %.
[[nodiscard]] std::string to_table(const std::vector<PlannedInspection>& inspections);

/// The content of `evaluation.json`.
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<PlannedInspection>& inspections);

}  // namespace rva
