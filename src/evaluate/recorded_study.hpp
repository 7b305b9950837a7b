// Evaluation of detection on captures of other cameras and simulators with known truth.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "evaluate/recorded_scene.hpp"

namespace rva {

/// One comparison of one scene.
struct RecordedResult {
  int captures = 1;                   ///< captures per side
  double allowed = 0.0;               ///< false findings allowed per inspection
  std::string method;                 ///< the method that was used
  std::size_t false_findings = 0;     ///< findings that are not of a target
  std::vector<bool> found;            ///< for each target
  std::string refused;                ///< why the comparison was refused; empty if it was not
  std::optional<double> error_mm{};   ///< of the registration, if there was one and the truth is known
  std::optional<double> error_deg{};  ///< angle of the same error
};

/// A recorded scene and the results of its comparisons.
struct RecordedInspection {
  RecordedScene scene;                  ///< captures and truth
  std::vector<RecordedResult> results;  ///< in the order of settings and numbers of captures
};

/// Compares each scene as `rva detect` does (detect() with `auto`), with one, up to four and all captures per
/// side, at 0.05, 0.5 and 2 allowed false findings. Findings are judged by judge(), as in simulated studies.
/// @throws Error if a scene cannot be read; Interrupted
[[nodiscard]] std::vector<RecordedInspection> run_recorded_study(const std::filesystem::path& folder,
                                                                 const Progress& progress);

/// A table with a row for each comparison of each scene, then totals, both with intervals of 95 %, and a list
/// of all objects that shows which comparisons found them.
[[nodiscard]] std::string to_table(const std::vector<RecordedInspection>& inspections);

/// The content of `evaluation.json`.
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<RecordedInspection>& inspections);

}  // namespace rva
