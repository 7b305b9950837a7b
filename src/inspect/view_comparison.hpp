// Before against after: one view, and all of an inspection.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cloud/spatial_detection.hpp"
#include "core/progress.hpp"
#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"

namespace rva {

struct Compared {
  std::vector<ComparedView> views;
  std::vector<ReviewedFinding> findings;  ///< of all views, most suspicious first
};

/// The captures of a view, in the order in which they were taken. @throws Error when one cannot be opened
[[nodiscard]] Captures open_captures(const InspectionFolder& folder, const Inspection& inspection, Side side,
                                     int view);

/// Compares each view's captures, and writes the results of all views with the map of the bay into a folder
/// of their own (InspectionFolder), whole or not at all.
/// @param number of the comparison, which no earlier one has
/// @param moved a robot carried the camera
/// @param chain where a camera is taken to be that does not say it
/// @throws Error when a capture is missing or cannot be compared; Interrupted
[[nodiscard]] Compared compare_sides(const InspectionFolder& folder, const Inspection& inspection, int number,
                                     bool moved, const PanTiltChain& chain, const Progress& progress);

/// What the folder of a comparison may hold, and that of one view's results, for an OutputFolder.
[[nodiscard]] std::vector<std::string> comparison_files();
[[nodiscard]] std::vector<std::string> view_result_files();

/// Says of findings of several views which are the same thing: of one kind, and nearer to each other in the
/// foot's frame than `reach_m`. Numbers and orders all of them.
[[nodiscard]] std::vector<ReviewedFinding> rank(std::vector<ReviewedFinding> findings, double reach_m = 0.03);

}  // namespace rva
