// Measures, while a capture is being taken, how much depth varies and what could be found.
#pragma once

#include <cstddef>
#include <vector>

#include "capture/capture.hpp"
#include "depth/depth_statistics.hpp"
#include "depth/image.hpp"
#include "detect/calibrated/level_of_detection.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva {

/// Noise of the frames so far.
struct NoiseSoFar {
  std::size_t frames = 0;
  double measured = 0.0;       ///< share of the depth image that is measured (DepthStatistics::seen())
  double median_std_mm = 0.0;  ///< median over the pixels of the standard deviation over time; 0 if unknown
  /// Levels of detection of a camera that returns exactly to this pose and takes as many frames. A camera on
  /// servos finds less.
  DetectionLevelSummary findable;
  Image<float> least_mm;  ///< the smallest height that could be found, by pixel; NaN where nothing could
};

/// Compares the even frames of a capture with its odd frames, as two captures between which nothing changed.
/// What that comparison could have found is what a comparison with a later capture will be able to find.
class NoiseWatch {
 public:
  explicit NoiseWatch(const CaptureInfo& info);

  /// @throws Error when the frame has another size
  void add(const DepthImage& frame);

  [[nodiscard]] std::size_t frames() const { return even_.frames() + odd_.frames(); }

  /// Whether there are two frames or more, all with the same depth: the camera was frozen, as noise makes
  /// every image differ from the others. False for images without any measurement.
  [[nodiscard]] bool frozen() const;

  /// Takes as long as a comparison. Requires at least two frames.
  [[nodiscard]] NoiseSoFar measure() const;

 private:
  StereoScale stereo_;
  double focal_px_;  // of the depth image
  DepthStatistics even_;
  DepthStatistics odd_;
  DepthImage first_;
  bool varies_ = false;  // whether a frame differed from the first one
};

}  // namespace rva
