// Registration of clouds as in the thesis (chapter 3.3, figure 3.17), with the library used there.
#pragma once

#include "core/options.hpp"
#include "core/progress.hpp"
#include "detect/thesis/point_cloud.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// Options of the thesis' incremental ICP.
struct IncrementalIcpOptions {
  int iterations = 20;
  double correspondence_m = 0.1;

  static void describe(auto&& self, auto&& visit) {
    visit(self.iterations,
          OptionField{"icp-iterations", "", 1, 1000, "octree: steps of registration; the thesis has 20"});
    visit(self.correspondence_m,
          OptionField{"icp-distance", "m", 0.001, 10,
                      "octree: points farther apart do not correspond; less with each step that changes "
                      "little"});
  }
};

/// Registers the initial cloud to the final one, starting from the identity, with PCL's
/// IterativeClosestPointNonLinear (Levenberg and Marquardt's method on nearest points). As in PCL's tutorial
/// "How to incrementally register pairs of clouds" and in the thesis, every step runs it for two iterations,
/// and the maximum distance of corresponding points shrinks by 1 mm whenever the last motion of the step
/// hardly differs from the one before.
/// @return final_from_initial
/// @throws Error where fewer than three points correspond; Interrupted
[[nodiscard]] Transform register_incrementally(const PointCloud& initial, const PointCloud& final,
                                               const IncrementalIcpOptions& options,
                                               const Progress& progress);

}  // namespace rva
