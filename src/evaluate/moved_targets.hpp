// Debris that a comparison of two places could find.
#pragma once

#include <vector>

#include "cloud/depth_view.hpp"
#include "evaluate/judgement.hpp"
#include "geometry/transform.hpp"
#include "sim/simulated_camera.hpp"

namespace rva {

/// What one detection must find.
struct MovedTarget {
  Target target;
  /// 15 mm across, 10 mm high, the smaller two of its sides.
  bool big = false;
  /// Half of it lies in space that the first initial capture saw through.
  bool seen_free = false;

  /// Visible, within 1 m, where there was free space.
  [[nodiscard]] bool counts() const { return target.is_visible() && target.distance_m <= 1.0 && seen_free; }
};

/// All debris of which the camera sees a pixel.
/// @param final   the camera of the first final capture
/// @param initial what the first initial capture measured
[[nodiscard]] std::vector<MovedTarget> moved_targets(const SimulatedCamera& final, const DepthView& initial,
                                                     const Transform& initial_from_final);

/// The targets by themselves, for judge().
[[nodiscard]] std::vector<Target> plain(const std::vector<MovedTarget>& targets);

}  // namespace rva
