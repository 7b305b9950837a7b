// Difference of two infrared images of nearly one pose, pixel by pixel.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "depth/image.hpp"
#include "infrared/dot_free_image.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {

/// Difference of one pair, in the reference view.
struct PairDifference {
  /// Change of the logarithm, without the effect of moved texture and without its level; 0 where not valid.
  Image<float> change;
  Image<float> brightness;  ///< logarithm of the darker image, as returned by log_grey()
  Image<float> steepness;   ///< gradient of the mean of both images, per pixel
  Mask valid;               ///< unset where either image is saturated, and near a border
};

/// Compares two images pixel by pixel in camera coordinates, since the projector turns with the camera and
/// dots stay at their pixels. Texture moved by the difference of both poses, which is corrected.
/// @param texture image of the surface, without gaps
[[nodiscard]] PairDifference pair_difference(const InfraredView& initial, const InfraredView& final,
                                             const ReferenceSurface& surface, const Image<float>& texture);

/// Standard deviation of the difference as a function of brightness and steepness of the image: at the flank
/// of a dot, half a pixel matters. It is learnt from the differences themselves, most of which are unchanged.
class PixelNoise {
 public:
  /// Learns the deviation for each class of brightness and steepness.
  explicit PixelNoise(const std::vector<PairDifference>& differences);

  /// Standard deviation of the difference at pixel i where nothing changed.
  [[nodiscard]] float at(const PairDifference& difference, std::size_t i) const {
    return deviation_[kind_of(difference, i)];
  }

 private:
  static constexpr std::array steep{0.02F, 0.05F, 0.1F, 0.15F, 0.2F, 0.3F, 0.4F, 0.6F, 0.8F};
  // Logarithms of grey levels plus three, as in log_grey().
  static constexpr std::array bright{1.4F, 1.6F, 1.8F, 2.1F, 2.4F, 2.8F, 3.1F, 3.6F, 4.1F, 4.6F};
  static constexpr std::size_t kinds = (steep.size() + 1) * (bright.size() + 1);

  [[nodiscard]] static std::size_t kind_of(const PairDifference& difference, std::size_t i);

  std::array<float, kinds> deviation_{};
};

}  // namespace rva
