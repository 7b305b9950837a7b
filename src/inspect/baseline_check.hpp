// What could be found in each view, from its baseline alone.
#pragma once

#include <string>
#include <vector>

#include "core/progress.hpp"
#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"

namespace rva {

/// Compares the first half of each view's baseline captures with the second half, as the sides of an
/// inspection are compared. Writes InspectionFolder::baseline_check(): `check.json` (docs/api.md), which has
/// of each view how many findings that shows, although nothing changed, and the levels of detection, or why
/// the halves could not be compared; each view's `level_of_detection.png`; and each view's
/// `depth_overlay.png` with what was found of nothing.
///
/// A side of the inspection has twice as many captures as a half, so that noise, and the levels with it, are
/// divided by the root of two.
///
/// Does nothing where a view has fewer than four captures, or the folder is there.
/// @throws Error when a capture cannot be read or the folder cannot be written; Interrupted
void check_baseline(const InspectionFolder& folder, const Inspection& inspection, const Progress& progress);

/// What that folder may hold, for an OutputFolder.
[[nodiscard]] std::vector<std::string> baseline_check_files();

}  // namespace rva
