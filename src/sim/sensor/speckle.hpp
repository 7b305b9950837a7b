// Laser speckle that persists, wanders and jumps: the reason why depth noise is not white.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "depth/image.hpp"
#include "geometry/pan_tilt.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva {

/// A speckle pattern, and its weight in the speckle of a view.
struct SpeckleShare {
  std::uint64_t seed = 0;  ///< determines the pattern
  double weight = 1.0;     ///< the squares of a view's weights sum to 1
};

/// The patterns that make up the speckle of a view. Speckle depends on the surface and on the position of the
/// imager, and changes as the camera turns. Patterns belong to the nodes of a grid over pan and tilt, with a
/// spacing of `speckle_turn_deg`. A view interpolates between the nodes around it, so nearby views share
/// some of their patterns.
/// @param speckle_turn_deg above 0
/// @param stand_seed       seed for all else that the pattern depends on: the camera and its position
[[nodiscard]] std::vector<SpeckleShare> speckle_shares(const PanTilt& turn, double speckle_turn_deg,
                                                       std::uint64_t stand_seed);

/// The relative change of the projector's light that one imager sees at each pixel, from frame to frame.
///
/// Laser light on a rough surface makes a grainy pattern that depends on the position of the imager. The two
/// imagers therefore see different patterns, which the matcher cannot distinguish from a shift. There are
/// three components:
/// - one that is constant while camera and scene are (a fixed depth error),
/// - one that wanders: separate fields, each weighted by a slow random process,
/// - one that jumps: each patch of the image keeps one of three patterns for a while (modes of the laser).
/// All of them reach depth through the matcher, so neighbours that share a window share their error.
class Speckle {
 public:
  /// @param view         the patterns of this imager and pose, see speckle_shares()
  /// @param capture_seed seed of everything that differs between two captures of one view
  Speckle(int width, int height, const StereoSensorOptions& options, const std::vector<SpeckleShare>& view,
          std::uint64_t capture_seed);

  /// Advances to the next frame; the first call prepares frame 0.
  void advance();

  /// Computes the sum of the components for one row.
  /// @param factor receives `width` values: 1 on average, never negative
  void row(int v, float* factor) const;

 private:
  static constexpr int wander_fields = 3;
  static constexpr int level_patterns = 3;
  static constexpr int patch_px = 12;

  void start();

  StereoSensorOptions options_;
  int width_;
  std::uint64_t capture_seed_;
  std::uint64_t frame_ = 0;
  bool started_ = false;
  Image<float> fixed_;
  std::vector<Image<float>> wandering_;
  std::vector<Image<float>> patterns_;
  std::array<double, wander_fields> weights_{};
  Image<std::uint8_t> patch_levels_;  // index of each patch's current pattern
};

}  // namespace rva
