// Before against after: one view, and all of an inspection.
#pragma once

#include <filesystem>
#include <vector>

#include "core/progress.hpp"
#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"

namespace rva {

struct Compared {
  std::vector<ComparedView> views;
  std::vector<ReviewedFinding> findings;  ///< of all views, most suspicious first
};

/// Compares each view's captures, by space that was seen through where a robot carried the camera and pixel
/// by pixel where it stood still, and writes each view's result into its folder, whole or not at all.
/// @param moved a robot carried the camera
/// @param chain where a camera is taken to be that does not say it
/// @throws Error when a capture is missing or cannot be compared; Interrupted
[[nodiscard]] Compared compare_sides(const InspectionFolder& folder, const Inspection& inspection, bool moved,
                                     const PanTiltChain& chain, const Progress& progress);

/// Says of findings of several views which are the same thing: of one kind, and nearer to each other in the
/// foot's frame than `reach_m`. Numbers and orders all of them.
[[nodiscard]] std::vector<ReviewedFinding> rank(std::vector<ReviewedFinding> findings, double reach_m = 0.03);

}  // namespace rva
