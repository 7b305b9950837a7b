// The result that every method returns, and helpers that methods share.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "capture/capture.hpp"
#include "core/progress.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/calibrated/level_of_detection.hpp"
#include "detect/findings/findings.hpp"
#include "detect/regions/comparison.hpp"

namespace rva {

/// How many frames of each capture are used.
struct FrameOptions {
  int frames = 0;

  static void describe(auto&& self, auto&& visit) {
    visit(self.frames, OptionField{"frames", "", 0, DepthStatistics::max_frames,
                                   "all but constant: frames of each capture to use, from the first; 0 "
                                   "for all"});
  }
};

/// What the inspection could have found, from methods that estimate it.
struct LevelOfDetection {
  Image<float> least_mm;  ///< least detectable height, mm; NaN where nothing could be judged
  DetectionLevelSummary summary;
};

/// The result of a detection, with what is needed to draw and to assess it.
struct Detection {
  Findings findings;
  std::optional<LevelOfDetection> level_of_detection;  ///< set by `calibrated` and `spatial`
  Mask changed;          ///< every changed pixel, including blobs below the minimum size
  Image<float> final_m;  ///< depth after, metres; 0 where not measured
  /// Depth before at the same pixels, metres, without drift where that is known; 0 where not measured.
  Image<float> initial_m;
  Mask left_out;  ///< pixels of the final depth image left out by the user; empty for none
  /// What limits the result, for the user; one line each.
  std::vector<std::string> warnings;
};

/// True if the captures' poses show that the camera moved in between; false if they match or are not stated.
[[nodiscard]] bool poses_differ(const CaptureInfo& initial, const CaptureInfo& final);

/// Checks that both captures are of one camera.
/// @throws Error when both state the serial number of their camera and the numbers differ
void require_one_device(const CaptureInfo& initial, const CaptureInfo& final);

/// Returns how many frames of a capture to use.
/// @param wanted   0 for all
/// @param side     "initial" or "final", for messages
/// @param warnings receives one if the capture has fewer frames than wanted
/// @throws Error when all frames are wanted and there are more than DepthStatistics::max_frames
[[nodiscard]] std::size_t frames_to_use(const Capture& capture, int wanted, std::string_view side,
                                        std::vector<std::string>& warnings);

/// Computes statistics of the first `frames` frames of a capture and adds the time taken to `runtime`.
/// @throws Error when a frame cannot be read; Interrupted
[[nodiscard]] DepthStatistics statistics_of(const Capture& capture, std::size_t frames,
                                            const Progress& progress, Runtime& runtime);

/// Adds warnings if so little was compared, or so many pixels are blind, that an empty list of findings
/// means little.
/// @param why the usual reason for blind pixels, which ends the warning
void warn_of_blindness(const Comparison& comparison, std::string_view why,
                       std::vector<std::string>& warnings);

}  // namespace rva
