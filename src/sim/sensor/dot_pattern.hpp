// The projector's pattern of dots.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "depth/image.hpp"

namespace rva {

/// Projected light by direction, relative to its mean. Dots of random brightness lie on a grid, over a
/// uniform background; each is shifted at random within its cell, so that neighbourhoods are distinguishable.
///
/// Directions are given as (x / z, y / z) in the projector's frame, whose axes are those of the depth imager.
class DotPattern {
 public:
  /// Half the projector's field of view, 86 x 57 deg (D400 datasheet), as tangents.
  static constexpr double half_width = 0.9325;
  static constexpr double half_height = 0.5430;  ///< tangent of half the vertical field of view

  /// @param dots      number of dots in the whole field; 0 for uniform light
  /// @param dot_share share of the light that is in dots, 0 to 1
  DotPattern(int dots, double dot_share, std::uint64_t seed);

  /// Relative intensity; 0 outside the field of view.
  [[nodiscard]] float at(float x, float y) const;

 private:
  void draw_dot(const Eigen::Vector2d& center, double peak);

  Image<float> table_;  // intensity over the field of view, in steps of `texel`
};

}  // namespace rva
