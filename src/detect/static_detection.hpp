// Detects changes between two captures of a camera that did not move.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "capture/capture.hpp"
#include "core/options.hpp"
#include "core/progress.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/calibrated/calibrated.hpp"
#include "detect/findings/detection.hpp"
#include "detect/regions/regions.hpp"
#include "detect/thesis/constant.hpp"
#include "detect/thesis/gaussian.hpp"

namespace rva {

enum class StaticMethod {
  constant,    ///< the first frame of either capture (algorithm 2 of the thesis)
  gaussian,    ///< statistics over all frames (algorithm 3 of the thesis)
  calibrated,  ///< means over all frames, against a noise model learnt from both captures
};

struct StaticDetectionOptions {
  StaticMethod method = StaticMethod::calibrated;
  int frames = 0;
  CalibratedOptions calibrated;
  ConstantOptions constant;
  GaussianOptions gaussian;
  RegionOptions regions;

  static void describe(auto&& self, auto&& visit) {
    visit(self.frames, OptionField{"frames", "", 0, DepthStatistics::max_frames,
                                   "all but constant: frames of each capture to use, from the first; 0 "
                                   "for all"});
    CalibratedOptions::describe(self.calibrated, visit);
    ConstantOptions::describe(self.constant, visit);
    GaussianOptions::describe(self.gaussian, visit);
    RegionOptions::describe(self.regions, visit);
  }
};

/// A detection and the statistics of the frames that it was computed from.
struct StaticDetection {
  Detection detection;
  DepthStatistics initial;
  DepthStatistics final;
};

/// Compares two captures pixel by pixel. It assumes that the camera stood still (detect/detect.hpp
/// checks this).
/// @param left_out pixels of the depth image to leave out; empty for none
/// @throws Error when the captures differ in camera, size, intrinsics or depth unit, when `gaussian` has
///         fewer than two frames of either, or when a frame cannot be read; UsageError for options out of
///         range; Interrupted
[[nodiscard]] StaticDetection detect_static(const Capture& initial, const Capture& final,
                                            const StaticDetectionOptions& options, const Progress& progress,
                                            const Mask& left_out = {});

[[nodiscard]] std::string_view name_of(StaticMethod method);

}  // namespace rva
