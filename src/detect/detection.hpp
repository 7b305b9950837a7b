// What every method answers, and what it needs of captures for it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.hpp"
#include "depth/capture.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/calibrated/level_of_detection.hpp"
#include "detect/comparison.hpp"
#include "detect/findings.hpp"

namespace rva {

/// Of a method that knows what it could have found.
struct LevelOfDetection {
  Image<float> least_mm;  ///< height; NaN where nothing could be judged
  DetectionLevelSummary summary;
};

struct Detection {
  Findings findings;
  std::optional<LevelOfDetection> level_of_detection;  ///< of `calibrated`
  Mask changed;          ///< every changed pixel, blobs below the least size included
  Image<float> final_m;  ///< depth after, metres; 0 where not measured
  Mask left_out;         ///< of the final depth image, as a person wished; empty where nothing was left out
  std::vector<std::string>
      warnings;  ///< for a person, one line each: what makes the result less than it seems
};

/// True when the captures' poses say that the camera moved in between; false where they say nothing.
[[nodiscard]] bool poses_differ(const CaptureInfo& initial, const CaptureInfo& final);

/// @throws Error when both captures state the serial number of their camera, and they differ
void require_one_device(const CaptureInfo& initial, const CaptureInfo& final);

/// How many frames of a capture to use.
/// @param wanted   0 for all
/// @param side     "initial", "final", for messages
/// @param warnings gets one where there are fewer than wanted
/// @throws Error when there are more than statistics can take
[[nodiscard]] std::size_t frames_to_use(const Capture& capture, int wanted, std::string_view side,
                                        std::vector<std::string>& warnings);

/// Of the first frames of a capture; adds what it took to `runtime`.
/// @throws Error when a frame cannot be read; Interrupted
[[nodiscard]] DepthStatistics statistics_of(const Capture& capture, std::size_t frames,
                                            const Progress& progress, Runtime& runtime);

/// Focal length times baseline. Disparities in true pixels need the baseline; where a capture does not state
/// it, the unit is that of a camera with 50 mm.
[[nodiscard]] double disparity_m_px(const CaptureInfo& info);

/// What the figures say against believing an empty list of findings.
/// @param why such places are, as a rule
void warn_of_blindness(const Comparison& comparison, std::string_view why,
                       std::vector<std::string>& warnings);

}  // namespace rva
