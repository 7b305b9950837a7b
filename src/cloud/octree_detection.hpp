// The thesis' spatial detection (chapter 3.3, figure 3.15): the baseline that `spatial` is held against.
#pragma once

#include "cloud/incremental_icp.hpp"
#include "cloud/point_cloud.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "depth/capture.hpp"
#include "detect/comparison.hpp"
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

/// A depth image, and what is known of it.
struct DepthFrame {
  const DepthImage& depth;
  const CaptureInfo& info;
};

/// Two clouds, cropped, in the frames of their cameras, and where one lies in the other.
struct RegisteredClouds {
  PointCloud initial;
  PointCloud final;
  Transform final_from_initial = Transform::Identity();
};

/// @throws Error where nothing is left, where the clouds cannot be registered, or where the lens bends rays;
///         Interrupted
[[nodiscard]] RegisteredClouds register_clouds(const DepthFrame& initial, const DepthFrame& final,
                                               const OctreeOptions& options, const Progress& progress);

/// What stands in cells that were empty before, pixel by pixel of the final image.
/// @param cell_m   edge of a cell, above 0
/// @param left_out as of is_left_out(), of the final image
[[nodiscard]] Comparison compare_clouds(const RegisteredClouds& clouds, const DepthFrame& final,
                                        double cell_m, const Mask& left_out = {});

/// Deprojects the first depth image of either capture, crops, registers from no motion at all, whatever poses
/// say, and calls the points in cells that were empty before changed.
///
/// Thesis: one cloud of either side, 20 steps of registration, cells of 5 cm. It knows nothing of noise, nor
/// of what was hidden before: newly visible area is change. Nothing that was removed is found.
/// @throws Error where the clouds cannot be registered or the lens bends rays; UsageError for options out of
///         range; Interrupted
[[nodiscard]] Detection detect_by_octree(const Capture& initial, const Capture& final,
                                         const OctreeOptions& options, const RegionOptions& regions,
                                         const Progress& progress, const Mask& left_out = {});

}  // namespace rva
