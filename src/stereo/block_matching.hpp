// Block matching to whole pixels: finds the pixel of the right image that sees the same point as a pixel of
// the left one.
#pragma once

#include <cstdint>

#include "depth/image.hpp"

namespace rva {

/// Image of one imager: 10 bits, 0 to 1023, with rows aligned to those of the other imager.
using InfraredImage = Image<std::uint16_t, struct ImagerCounts>;

/// Settings of block matching with census costs.
struct BlockMatchingOptions {
  int search_px = 126;        ///< largest disparity, which determines the least distance
  int window_px = 9;          ///< costs are summed over a square of this edge, odd
  int census_threshold = 20;  ///< levels by which a neighbour must be brighter to count: above the read noise
  /// The best cost must be lower than any other (apart from its neighbours) by this share. If there is no
  /// other, there is no match.
  double uniqueness = 0.03;
  int left_right_px = 1;  ///< tolerance of the left-right check
};

/// Disparity of a pixel without a match.
inline constexpr std::uint8_t no_match = 0;

/// Winner-takes-all over summed census costs (Zabih and Woodfill, ECCV 1994) with a left-right check.
/// @param left, right of one size, at least as wide and high as the windows
/// @return disparity of each pixel of the left image, whole pixels, 1 to search_px, or `no_match`: what the
///         left imager sees at column u, the right one sees at u - disparity
[[nodiscard]] Image<std::uint8_t> match_blocks(const InfraredImage& left, const InfraredImage& right,
                                               const BlockMatchingOptions& options);

/// The census of each pixel: bit i is set if the i-th of 16 neighbours within 7 x 7 pixels is brighter than
/// the pixel by more than the threshold. Border pixels are repeated outside the image.
[[nodiscard]] Image<std::uint16_t> census(const InfraredImage& image, int threshold);

}  // namespace rva
