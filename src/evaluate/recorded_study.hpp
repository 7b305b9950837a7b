// How reliably change is found on captures of other cameras and simulators, of which the truth is known.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "evaluate/recorded_scene.hpp"

namespace rva {

/// One comparison of one scene.
struct RecordedResult {
  int captures = 1;  ///< a side
  double allowed = 0.0;
  std::string method;  ///< that was used
  std::size_t false_findings = 0;
  std::vector<bool> found;           ///< of each target
  std::string refused;               ///< why it could not be compared; empty where it was
  std::optional<double> error_mm{};  ///< of the registration, where there was one and the truth is known
  std::optional<double> error_deg{};
};

struct RecordedInspection {
  RecordedScene scene;
  std::vector<RecordedResult> results;
};

/// Compares each scene as `rva detect` does (detect() with `auto`), with one, four and all captures a side as
/// far as there are, at 0.05, 0.5 and 2 false findings allowed, and judges findings as the simulated studies
/// do (judge()).
/// @throws Error when a scene cannot be read; Interrupted
[[nodiscard]] std::vector<RecordedInspection> run_recorded_study(const std::filesystem::path& folder,
                                                                 const Progress& progress);

/// A table with a row for each comparison of each scene, then totals, both with intervals of 95 %, and a list
/// of all objects with whether each comparison found them.
[[nodiscard]] std::string to_table(const std::vector<RecordedInspection>& inspections);

/// `evaluation.json`
[[nodiscard]] std::string to_json(const std::vector<RecordedInspection>& inspections);

}  // namespace rva
