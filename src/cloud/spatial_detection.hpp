// From captures of a camera that was moved in between to findings.
#pragma once

#include <memory>
#include <vector>

#include "cloud/registration.hpp"
#include "cloud/spatial_comparison.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "depth/capture.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/calibrated/calibrated.hpp"
#include "detect/detection.hpp"
#include "detect/regions.hpp"

namespace rva {

struct SpatialDetectionOptions {
  int frames = 0;
  CalibratedOptions calibrated;
  RegionOptions regions;
  KnownMotion known = KnownMotion::moved;
  /// Share of the allowed false findings that is left to depth where the camera came back nearly: infrared
  /// images take the rest there.
  double share = 1.0;
  /// Changes of depth are held against the pairs of both imagers (surface_support.hpp), but where infrared
  /// images take a share. Every capture must have them.
  bool pairs = false;

  static void describe(auto&& self, auto&& visit) {
    visit(self.frames, OptionField{"frames", "", 0, DepthStatistics::max_frames,
                                   "frames of each capture to use; 0 for all"});
    CalibratedOptions::describe(self.calibrated, visit);
    RegionOptions::describe(self.regions, visit);
  }
};

/// Where the captures of either side were taken, and the surface that the final ones saw.
struct PlacedCaptures {
  std::vector<Transform>
      first_from_initial;                   ///< in the frame of the first initial capture, that one included
  std::vector<Transform> first_from_final;  ///< in the frame of the first final one
  DepthView final_view;                     ///< of the final captures together, in the first one's camera
};

struct SpatialDetection {
  Detection detection;        ///< in the view of the first final capture
  Registration registration;  ///< of the first captures of either side
  PlacedCaptures placed;
};

/// True within 3 degrees and 20 mm: farther away, surfaces hide others, and light comes from elsewhere.
[[nodiscard]] bool came_back_nearly(const Transform& initial_from_final);

/// Lays the views over each other, and compares what each saw through with what the other saw there
/// (docs/spatial.md). Poses of one base are where the search begins; they are believed to the last digit
/// where the images do not contradict them. Where each final capture has an initial one of the same pose and
/// the images show no motion between the two, they are compared pixel by pixel.
/// @param initial, final captures of one side from nearly one place, one at least
/// @param left_out       pixels of the first initial depth image that a person wants left out; empty for none
/// @throws Error when the registration is not to be trusted, the lens bends rays, the captures of one side
///         differ in camera, or a frame cannot be read; UsageError for options out of range; Interrupted
[[nodiscard]] SpatialDetection detect_spatial(const Captures& initial, const Captures& final,
                                              const SpatialDetectionOptions& options,
                                              const Progress& progress, const Mask& left_out = {});

/// `registration.json`: the transform, its covariance, and how well the views agree (docs/spatial.md).
[[nodiscard]] std::string to_json(const Registration& registration);

}  // namespace rva
