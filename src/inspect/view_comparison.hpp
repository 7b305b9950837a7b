// Compares the initial with the final side, for all views of an inspection.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "detect/spatial/spatial_detection.hpp"
#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"

namespace rva {

/// The result of the comparison of all views of an inspection.
struct Compared {
  std::vector<ComparedView> views;
  std::vector<ReviewedFinding> findings;  ///< of all views, most suspicious first
};

/// The captures of a view, in the order in which they were taken. @throws Error when one cannot be opened
[[nodiscard]] Captures open_captures(const InspectionFolder& folder, const Inspection& inspection, Side side,
                                     int view);

/// Compares the captures of each view, and writes the results of all views, with the map of the bay, into a
/// folder of their own (comparison_files()), either completely or not at all.
/// @param folder in which the captures are
/// @param out the folder to appear with the results
/// @param moved whether a robot carried the camera
/// @param chain the robot's geometry, from which the poses of captures that state none are taken
/// @throws Error when a capture is missing or cannot be compared; ExistsError when `out` exists; Interrupted
[[nodiscard]] Compared compare_sides(const InspectionFolder& folder, const Inspection& inspection,
                                     const std::filesystem::path& out, bool moved, const PanTiltChain& chain,
                                     const Progress& progress);

/// The files that the folder of a comparison, and that of one view's results, may contain, in the form that
/// OutputFolder takes.
[[nodiscard]] std::vector<std::string> comparison_files();
[[nodiscard]] std::vector<std::string> view_result_files();

/// Orders and numbers the findings of several views, most suspicious first: what is not planned, then missing
/// and surplus parts, then what is planned (ReviewedFinding::planned). Sets `same_as` of those that
/// show the same object: findings of the same kind in different views, less than `reach_m` metres apart in
/// the frame of the robot's foot.
[[nodiscard]] std::vector<ReviewedFinding> rank(std::vector<ReviewedFinding> findings, double reach_m = 0.03);

}  // namespace rva
