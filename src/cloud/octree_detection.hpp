// The thesis' spatial detection (chapter 3.3, figure 3.15): the baseline that `spatial` is held against.
#pragma once

#include "cloud/incremental_icp.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "depth/capture.hpp"
#include "detect/detection.hpp"
#include "detect/regions.hpp"

namespace rva {

struct OctreeOptions {
  double cell_m = 0.05;
  double far_m = 2.0;
  double above_m = 1.0;
  double below_m = 1.0;
  IncrementalIcpOptions icp;

  static void describe(auto&& self, auto&& visit) {
    visit(self.cell_m,
          OptionField{"octree-cell", "m", 0.001, 10, "octree: edge of a cell; the thesis has 5 cm"});
    visit(self.far_m, OptionField{"octree-far", "m", 0.01, 1000, "octree: points beyond are left out"});
    visit(self.above_m, OptionField{"octree-above", "m", 0, 1000,
                                    "octree: points higher above the camera's axis are left out"});
    visit(self.below_m, OptionField{"octree-below", "m", 0, 1000,
                                    "octree: points deeper below the camera's axis are left out"});
    IncrementalIcpOptions::describe(self.icp, visit);
  }
};

/// Deprojects the first depth image of either capture, crops, registers from no motion at all, whatever poses
/// say, and calls the points in cells that were empty before changed.
///
/// Thesis: one cloud of either side, 20 steps of registration, cells of 5 cm. It knows nothing of noise, nor
/// of what was hidden before: newly visible area is change. Nothing that was removed is found.
/// @throws Error where the clouds cannot be registered or the lens bends rays; UsageError for options out of
///         range; Interrupted
[[nodiscard]] Detection detect_by_octree(const Capture& initial, const Capture& final,
                                         const OctreeOptions& options, const RegionOptions& regions,
                                         const Progress& progress);

}  // namespace rva
