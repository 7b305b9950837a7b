// From two captures of a camera that did not move to findings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/options.hpp"
#include "core/progress.hpp"
#include "depth/capture.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/calibrated/calibrated.hpp"
#include "detect/constant.hpp"
#include "detect/findings.hpp"
#include "detect/gaussian.hpp"
#include "detect/regions.hpp"

namespace rva {

enum class StaticMethod {
  constant,    ///< the first frame of either capture, algorithm 2
  gaussian,    ///< statistics over all frames, algorithm 3
  calibrated,  ///< means over all frames against the noise that both captures show
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
                                   "gaussian, calibrated: frames of either capture to use, from the first; 0 "
                                   "for all"});
    CalibratedOptions::describe(self.calibrated, visit);
    ConstantOptions::describe(self.constant, visit);
    GaussianOptions::describe(self.gaussian, visit);
    RegionOptions::describe(self.regions, visit);
  }
};

/// Of a method that knows what it could have found.
struct LevelOfDetection {
  Image<float> least_mm;  ///< height; NaN where nothing could be judged
  DetectionLevelSummary summary;
};

struct StaticDetection {
  Findings findings;
  std::optional<LevelOfDetection> level_of_detection;  ///< of `calibrated`
  Mask changed;          ///< every changed pixel, blobs below the least size included
  Image<float> final_m;  ///< depth after, metres; 0 where not measured
  std::vector<std::string>
      warnings;  ///< for a person, one line each: what makes the result less than it seems
};

/// @throws Error when the captures differ in size, intrinsics or depth unit, when `gaussian` has fewer than
/// two
///         frames of either, or a frame cannot be read; UsageError for options out of range; Interrupted
[[nodiscard]] StaticDetection detect_static(const Capture& initial, const Capture& final,
                                            const StaticDetectionOptions& options, const Progress& progress);

[[nodiscard]] std::string_view name_of(StaticMethod method);

}  // namespace rva
