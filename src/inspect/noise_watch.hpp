// While a capture is being taken: how much depth varies, and what could be found here.
#pragma once

#include <cstddef>
#include <vector>

#include "depth/capture.hpp"
#include "depth/depth_statistics.hpp"
#include "depth/image.hpp"
#include "detect/calibrated/level_of_detection.hpp"

namespace rva {

/// Of the frames so far.
struct NoiseSoFar {
  std::size_t frames = 0;
  double measured = 0.0;       ///< share of the depth image that is seen
  double median_std_mm = 0.0;  ///< of a pixel over time; 0 where fewer than two frames
  /// What this camera would find that comes back exactly and takes as many frames: the least to be hoped for
  /// of a camera on servos.
  DetectionLevelSummary findable;
  Image<float> least_mm;  ///< height of the least thing that could be found; NaN where nothing could
};

/// Two halves of one capture, every second frame each, are two captures between which nothing happened: what
/// a comparison of them could have found is what one with a later capture will.
class NoiseWatch {
 public:
  explicit NoiseWatch(const CaptureInfo& info);

  /// @throws Error when the frame is of another size
  void add(const DepthImage& frame);

  [[nodiscard]] std::size_t frames() const { return even_.frames() + odd_.frames(); }

  /// Takes as long as a comparison does. There must be two frames at least.
  [[nodiscard]] NoiseSoFar measure() const;

 private:
  double unit_m_;
  double disparity_m_px_;
  DepthStatistics even_;
  DepthStatistics odd_;
};

}  // namespace rva
