// The methods for a camera that stood still: each compares two sides pixel by pixel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "core/options.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/calibrated/calibrated.hpp"
#include "detect/findings/detection.hpp"
#include "detect/method.hpp"
#include "detect/regions/regions.hpp"
#include "detect/thesis/constant.hpp"
#include "detect/thesis/gaussian.hpp"

namespace rva {

/// Options of the static methods.
struct StaticDetectionOptions {
  DetectionMethod method = DetectionMethod::calibrated;  ///< one with a static_method()
  FrameOptions use;
  CalibratedOptions calibrated;
  ConstantOptions constant;
  GaussianOptions gaussian;
  RegionOptions regions;

  static void describe(auto&& self, auto&& visit) {
    FrameOptions::describe(self.use, visit);
    CalibratedOptions::describe(self.calibrated, visit);
    ConstantOptions::describe(self.constant, visit);
    GaussianOptions::describe(self.gaussian, visit);
    RegionOptions::describe(self.regions, visit);
  }
};

/// What a method compares: statistics of one camera with one depth unit.
struct StaticSides {
  const DepthStatistics& initial;
  const DepthStatistics& final;
  const CaptureInfo& info;  ///< of the final capture
  const Mask& left_out;     ///< pixels left out by the user; empty for none
  /// False if a tool may have removed depth, so that lost depth is no evidence.
  bool losses_count = true;
};

/// The result of a static method, before regions are formed.
struct StaticComparison {
  Comparison comparison;
  std::optional<LevelOfDetection> level_of_detection{};  ///< of methods that estimate it
  Parameters parameters{};                               ///< the method's own options
  std::vector<std::string> warnings{};
};

/// A row of the table of static methods.
struct StaticMethod {
  DetectionMethod method;
  bool first_frame_only;  ///< compares the first frame of each side, of which the statistics consist
  /// @throws Error when the statistics have too few frames for the method
  StaticComparison (*compare)(const StaticSides& sides, const StaticDetectionOptions& options);
};

[[nodiscard]] bool is_static(DetectionMethod method);
/// @param method with is_static()
[[nodiscard]] const StaticMethod& static_method(DetectionMethod method);

}  // namespace rva
