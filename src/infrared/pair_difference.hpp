// Two infrared images from nearly one pose: what differs, pixel by pixel.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "depth/image.hpp"
#include "infrared/dot_free_image.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {

/// What one pair shows, in the reference's view.
struct PairDifference {
  Image<float>
      change;  ///< of the logarithm, without what texture explains, less its level; 0 where not valid
  Image<float> brightness;  ///< the lesser one's logarithm, as of log_grey()
  Image<float> steepness;   ///< of both images' mean, per pixel
  Mask valid;               ///< unset where either is saturated, or near a border
};

/// Both images are taken pixel upon pixel as the camera took them, since the projector turns with it. Texture
/// moved by the difference of both poses.
/// @param texture of the surface, without gaps
[[nodiscard]] PairDifference pair_difference(const InfraredView& initial, const InfraredView& final,
                                             const ReferenceSurface& surface, const Image<float>& texture);

/// The deviation of pixels by how bright and how steep the image is there: where a dot falls off, half a
/// pixel matters. Learnt from what differs itself, most of which is unchanged.
class PixelNoise {
 public:
  explicit PixelNoise(const std::vector<PairDifference>& differences);

  [[nodiscard]] float at(const PairDifference& difference, std::size_t i) const {
    return deviation_[kind_of(difference, i)];
  }

 private:
  static constexpr std::array steep{0.02F, 0.05F, 0.1F, 0.15F, 0.2F, 0.3F, 0.4F, 0.6F, 0.8F};
  // Logarithms of grey levels and three.
  static constexpr std::array bright{1.4F, 1.6F, 1.8F, 2.1F, 2.4F, 2.8F, 3.1F, 3.6F, 4.1F, 4.6F};
  static constexpr std::size_t kinds = (steep.size() + 1) * (bright.size() + 1);

  [[nodiscard]] static std::size_t kind_of(const PairDifference& difference, std::size_t i);

  std::array<float, kinds> deviation_{};
};

}  // namespace rva
