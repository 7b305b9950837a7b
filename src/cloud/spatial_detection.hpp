// From captures of a camera that was moved in between to findings.
#pragma once

#include <memory>
#include <vector>

#include "cloud/registration.hpp"
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
  /// Poses of one base are where the cameras stood, to the last digit; else as nearly as servos come to it,
  /// and a search begins there.
  bool exact_poses = true;

  static void describe(auto&& self, auto&& visit) {
    visit(self.frames, OptionField{"frames", "", 0, DepthStatistics::max_frames,
                                   "frames of each capture to use; 0 for all"});
    CalibratedOptions::describe(self.calibrated, visit);
    RegionOptions::describe(self.regions, visit);
  }
};

struct SpatialDetection {
  Detection detection;        ///< in the view of the first final capture
  Registration registration;  ///< of the first captures of either side
};

using Captures = std::vector<std::unique_ptr<Capture>>;

/// Lays the views over each other, and compares what each saw through with what the other saw there
/// (docs/spatial.md). Captures of one side whose poses name one base stand where their poses say; others are
/// registered. Where both sides name one base, the search for the move begins there, and looks no farther.
/// @param initial, final captures of one side from nearly one place, one at least
/// @throws Error when the registration is not to be trusted, the lens bends rays, the captures of one side
///         differ in camera, or a frame cannot be read; UsageError for options out of range; Interrupted
[[nodiscard]] SpatialDetection detect_spatial(const Captures& initial, const Captures& final,
                                              const SpatialDetectionOptions& options,
                                              const Progress& progress);

/// `registration.json`: the transform, its covariance, and how well the views agree (docs/spatial.md).
[[nodiscard]] std::string to_json(const Registration& registration);

}  // namespace rva
