// Estimates from the baseline alone what could be found in each view.
#pragma once

#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "core/progress.hpp"
#include "detect/findings/detection.hpp"
#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"

namespace rva {

/// Compares the first half of a view's baseline captures with the second half. The level of detection is that
/// which a comparison of all of them with as many captures after the work is expected to reach: half of that
/// of the halves, since those have half as many captures, from other poses than each other.
/// @param baseline at least two captures
/// @throws Error as detect() does; Interrupted
[[nodiscard]] Detection expected_detection(Captures baseline, const Progress& progress);

/// Compares the first half of each view's baseline captures with the second half, in the way that the two
/// sides of an inspection are compared. Writes the folder InspectionFolder::baseline_check(): `check.json`
/// (docs/api.md), which states for each view the number of findings (all of them false, because nothing
/// changed) and the levels of detection, or why the halves could not be compared; `level_of_detection.png` of
/// each view; and `depth_overlay.png` of each view with the false findings marked.
///
/// The levels of detection and the shares in which objects would be found are those of expected_detection().
///
/// Does nothing if a view has fewer than four captures or the folder already exists. A capture that cannot be
/// read is reported as the problem of its view.
/// @throws Error when the folder cannot be written or a symbolic link leads to it; Interrupted
void check_baseline(const InspectionFolder& folder, const Inspection& inspection, const Progress& progress);

/// The files that this folder may contain, in the form that OutputFolder takes.
[[nodiscard]] std::vector<std::string> baseline_check_files();

}  // namespace rva
