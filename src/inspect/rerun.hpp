// Computes a recorded comparison again from its captures, and states in what the results differ.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"
#include "inspect/view_comparison.hpp"

namespace rva {

/// A comparison that was computed again.
struct Rerun {
  std::size_t files = 0;                 ///< number of files that the recorded results have
  std::size_t findings = 0;              ///< number of findings that the records contain
  std::vector<std::string> differences;  ///< a line each; empty where nothing differs
};

/// What differs between two results of a comparison, each as one line that begins with the name of a file.
/// Files are compared by their bytes; of those in JSON, which contain the time of their making
/// (`provenance.created_at`) and run times (`runtime_ms`), all other values are compared.
/// @param recorded folder of the earlier results, for example InspectionFolder::comparison_name()
/// @param again folder of the later ones
/// @throws Error when a folder or a file cannot be read
[[nodiscard]] std::vector<std::string> differences_between(const std::filesystem::path& recorded,
                                                           const std::filesystem::path& again);

/// What differs between findings that were recorded and those that were computed again, one line each. Of a
/// finding, its view, kind, box, score and state in the plan are compared, and which others show the same
/// object.
[[nodiscard]] std::vector<std::string> differences_between(const std::vector<ReviewedFinding>& recorded,
                                                           const std::vector<ReviewedFinding>& again);

/// The number of the latest comparison of an inspection. @throws Error when it has none
[[nodiscard]] int latest_comparison(const InspectionHistory& history);

/// Compares the sides again from the captures that a recorded comparison used, with the regions and plans
/// that the inspection has now; changing these outdates the latest comparison, but earlier ones may have had
/// others.
/// @param number of the comparison
/// @param chain the robot's geometry, as of the server that wrote the recorded results
/// @param out folder to appear with the results
/// @throws Error when there is no such comparison, it is of an earlier version that did not record which
///         captures it compared, its results were replaced, or a capture is missing or cannot be compared;
///         ExistsError when `out` exists; Interrupted
[[nodiscard]] Rerun rerun_comparison(const InspectionHistory& history, const InspectionFolder& folder,
                                     int number, const PanTiltChain& chain, const std::filesystem::path& out,
                                     const Progress& progress);

}  // namespace rva
