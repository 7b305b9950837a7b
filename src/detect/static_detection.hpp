// Detects changes between two captures of a camera that did not move.
#pragma once

#include "capture/capture.hpp"
#include "core/progress.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/findings/detection.hpp"
#include "detect/static_method.hpp"

namespace rva {

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

}  // namespace rva
