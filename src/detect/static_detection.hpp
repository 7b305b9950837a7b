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
#include "detect/constant.hpp"
#include "detect/findings.hpp"
#include "detect/gaussian.hpp"
#include "detect/regions.hpp"

namespace rva {

enum class StaticMethod {
  constant,  ///< the first frame of either capture, algorithm 2
  gaussian,  ///< statistics over all frames, algorithm 3
};

struct StaticDetectionOptions {
  StaticMethod method = StaticMethod::gaussian;
  int frames = 0;
  ConstantOptions constant;
  GaussianOptions gaussian;
  RegionOptions regions;

  static void describe(auto&& self, auto&& visit) {
    visit(self.frames, OptionField{"frames", "", 0, DepthStatistics::max_frames,
                                   "gaussian: frames of either capture to use, from the first; 0 for all"});
    ConstantOptions::describe(self.constant, visit);
    GaussianOptions::describe(self.gaussian, visit);
    RegionOptions::describe(self.regions, visit);
  }
};

struct StaticDetection {
  Findings findings;
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
