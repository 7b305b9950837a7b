// Detects changes between captures of a camera that was moved in between.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "capture/capture.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/calibrated/calibrated.hpp"
#include "detect/findings/detection.hpp"
#include "detect/regions/regions.hpp"
#include "detect/spatial/spatial_comparison.hpp"
#include "views/registration.hpp"

namespace rva {

/// Options of the method `spatial`.
struct SpatialDetectionOptions {
  FrameOptions use;
  CalibratedOptions calibrated;
  RegionOptions regions;
  KnownMotion known = KnownMotion::moved;
  /// Share of the allowed false findings that is assigned to depth if the camera returned nearly; the rest is
  /// assigned to infrared images there.
  double share = 1.0;
  /// Whether changes of depth are checked against the stereo pairs (surface_support.hpp), except where
  /// infrared images have a share of the false findings. Every capture must have the images of both imagers.
  bool pairs = false;

  static void describe(auto&& self, auto&& visit) {
    FrameOptions::describe(self.use, visit);
    CalibratedOptions::describe(self.calibrated, visit);
    RegionOptions::describe(self.regions, visit);
  }
};

/// Poses of the captures of either side, and the surface seen by the final ones.
struct PlacedCaptures {
  std::vector<Transform> first_from_initial;  ///< in the frame of the first initial capture, itself included
  std::vector<Transform> first_from_final;    ///< in the frame of the first final one
  DepthView final_view;                       ///< of all final captures, in the camera of the first one
};

/// The result of the method `spatial`.
struct SpatialDetection {
  Detection detection;        ///< in the view of the first final capture
  Registration registration;  ///< of the first captures of either side
  PlacedCaptures placed;
};

/// True within 3 degrees and 20 mm. Beyond that, different surfaces are occluded, and the light comes
/// from elsewhere.
[[nodiscard]] bool came_back_nearly(const Transform& initial_from_final);

/// Registers the views, and compares the space that each saw through with the surfaces that the other saw
/// there (docs/spatial.md). The search starts from the stated poses if these have the same base; they are
/// used exactly unless the images contradict them. If each final capture has an initial one of the same pose
/// and the images show no motion between the two, captures are compared pixel by pixel.
/// @param initial, final captures of one side from nearly one pose, at least one each
/// @param left_out       pixels of the first initial depth image to leave out; empty for none
/// @throws Error when the registration is not reliable, the camera has lens distortion, the captures of one
///         side differ in camera, or a frame cannot be read; UsageError for options out of range; Interrupted
[[nodiscard]] SpatialDetection detect_spatial(const Captures& initial, const Captures& final,
                                              const SpatialDetectionOptions& options,
                                              const Progress& progress, const Mask& left_out = {});

/// The content of `registration.json`: the transform, its covariance, and how well the views
/// fit (docs/spatial.md).
[[nodiscard]] nlohmann::ordered_json json_of(const Registration& registration);

}  // namespace rva
