// One side of a simulated inspection: dithered captures of one scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloud/fused_change.hpp"
#include "cloud/fused_view.hpp"
#include "cloud/octree_detection.hpp"
#include "depth/depth_statistics.hpp"
#include "robot/dither.hpp"
#include "sim/simulated_camera.hpp"

namespace rva {

/// Captures are taken as they are needed; those of one seed and number are always the same.
class DitheredSide {
 public:
  /// @param frames of each capture, above 0
  DitheredSide(Scene scene, const StereoSensorOptions& sensor, std::uint64_t seed, int frames);

  /// Takes captures until there are so many, `most_dithers` at most.
  void up_to(int captures);

  // Of all captures taken so far, at least one:

  [[nodiscard]] DepthView fused() const { return fuse(views_); }
  [[nodiscard]] const DepthView& first() const { return views_.front().view; }
  /// The first capture's first frame.
  [[nodiscard]] DepthFrame first_frame() const { return {first_depth_, info_}; }
  [[nodiscard]] double unit_m() const { return info_.depth_unit_m; }
  [[nodiscard]] double disparity_m_px() const { return first().disparity_m_px; }
  /// Of the first one.
  [[nodiscard]] Transform world_from_camera() const { return world_from_first_; }
  /// Capture by capture.
  /// @param initial as many captures, from the same places
  [[nodiscard]] std::vector<PlacedChange> changes_since(const DitheredSide& initial) const;

  /// The camera of one capture, before its first frame.
  [[nodiscard]] SimulatedCamera camera(std::size_t number) const;

 private:
  void take();

  Scene scene_;
  StereoSensorOptions sensor_;
  std::uint64_t seed_;
  int frames_;
  std::vector<PanTilt> offsets_;
  std::vector<PlacedView> views_;
  std::vector<DepthStatistics> statistics_;
  CaptureInfo info_;
  DepthImage first_depth_;
  Transform world_from_first_ = Transform::Identity();
};

}  // namespace rva
