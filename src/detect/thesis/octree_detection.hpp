// Spatial detection as in the thesis (chapter 3.3, figure 3.15), as a reference for `spatial`.
#pragma once

#include "capture/capture.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "detect/findings/detection.hpp"
#include "detect/regions/comparison.hpp"
#include "detect/regions/regions.hpp"
#include "detect/thesis/incremental_icp.hpp"
#include "detect/thesis/point_cloud.hpp"

namespace rva {

/// Options of the thesis' detection with an octree.
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

/// A depth image with the description of its capture.
struct DepthFrame {
  const DepthImage& depth;
  const CaptureInfo& info;
};

/// Two cropped clouds in the frames of their cameras, and the transform between them.
struct RegisteredClouds {
  PointCloud initial;
  PointCloud final;
  Transform final_from_initial = Transform::Identity();
};

/// Deprojects, crops and registers two depth images.
/// @throws Error when no point is left, when the clouds cannot be registered, or when the camera has lens
///         distortion; Interrupted
[[nodiscard]] RegisteredClouds register_clouds(const DepthFrame& initial, const DepthFrame& final,
                                               const OctreeOptions& options, const Progress& progress);

/// Marks the pixels of the final image whose points lie in cells that were empty before.
/// @param cell_m   edge of a cell, metres; above 0
/// @param left_out pixels of the final image to leave out, see is_left_out()
[[nodiscard]] Comparison compare_clouds(const RegisteredClouds& clouds, const DepthFrame& final,
                                        double cell_m, const Mask& left_out = {});

/// Deprojects the first depth image of either capture, crops, registers starting from the identity regardless
/// of stated poses, and marks points in cells that were empty before as changed.
///
/// Parameters of the thesis: one cloud of either side, 20 steps of registration, cells of 5 cm. The
/// method models neither noise nor occlusion: newly visible surfaces count as changes. Removed objects
/// are not found.
/// @throws Error when the clouds cannot be registered or the camera has lens distortion; UsageError for
///         options out of range; Interrupted
[[nodiscard]] Detection detect_by_octree(const Capture& initial, const Capture& final,
                                         const OctreeOptions& options, const RegionOptions& regions,
                                         const Progress& progress, const Mask& left_out = {});

}  // namespace rva
