// Debris that a comparison between two camera positions can be expected to find.
#pragma once

#include <vector>

#include "evaluate/judgement.hpp"
#include "geometry/transform.hpp"
#include "sim/simulated_camera.hpp"
#include "views/depth_view.hpp"

namespace rva {

/// One piece of debris in the first final capture.
struct MovedTarget {
  Target target;  ///< as seen by the first final capture
  /// The smallest side of its bounding box is at least 10 mm and the middle one at least 15 mm.
  bool big = false;
  /// At least half of it lies in space that the first initial capture observed as free.
  bool seen_free = false;

  /// Whether detection is expected: visible, within 1 m, and in space that was observed as free.
  [[nodiscard]] bool counts() const { return target.is_visible() && target.distance_m <= 1.0 && seen_free; }
};

/// All debris of which the camera sees a pixel.
/// @param final   the camera of the first final capture
/// @param initial the depth of the first initial capture
[[nodiscard]] std::vector<MovedTarget> moved_targets(const SimulatedCamera& final, const DepthView& initial,
                                                     const Transform& initial_from_final);

/// The bare targets, for judge().
[[nodiscard]] std::vector<Target> plain(const std::vector<MovedTarget>& targets);

}  // namespace rva
