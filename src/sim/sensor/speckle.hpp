// Why depth noise is not white: laser speckle that stays, wanders and jumps.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "depth/image.hpp"
#include "geometry/pan_tilt.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva {

/// A pattern of speckle, and how much of a view's it makes.
struct SpeckleShare {
  std::uint64_t seed = 0;
  double weight = 1.0;  ///< the squares of a view's weights sum to 1
};

/// The patterns that make a view's speckle. It depends on the surface and on where the eye is, and becomes
/// another as the camera turns: views within `speckle_turn_deg` share patterns, which belong to the points of
/// a grid of pan and tilt.
/// @param speckle_turn_deg above 0
/// @param stand_seed of all else that the pattern depends on: the camera, and where it stands
[[nodiscard]] std::vector<SpeckleShare> speckle_shares(const PanTilt& turn, double speckle_turn_deg,
                                                       std::uint64_t stand_seed);

/// The relative change of the projector's light that one imager sees at each pixel, from frame to frame.
///
/// A laser's light on a rough surface makes a grainy pattern that depends on where the eye is, so the two
/// imagers see different ones and the matcher cannot tell them from a shift. Three parts:
/// - one that stays while camera and scene do (a fixed error of depth),
/// - one that wanders: fields of their own, each weighted by a slow random process,
/// - one that jumps: patches of the image each hold one of three patterns for a while (modes of the laser).
/// All reach depth through the matcher, so neighbours that share a window share their error.
class Speckle {
 public:
  /// @param view         what the pattern depends on while nothing moves: the camera, the eye, its pose
  /// @param capture_seed what differs between two captures of one view
  Speckle(int width, int height, const StereoSensorOptions& options, const std::vector<SpeckleShare>& view,
          std::uint64_t capture_seed);

  /// Goes on to the next frame; the first call prepares frame 0.
  void advance();

  /// Adds up the parts for one row. @param factor at least `width` values: 1 on average, never negative
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
  Image<std::uint8_t> patch_levels_;  // which pattern each patch holds
};

}  // namespace rva
