// Which pixel of the right imager sees what a pixel of the left one sees, to whole pixels.
#pragma once

#include <cstdint>

#include "depth/image.hpp"

namespace rva {

/// What an imager delivers: 10 bits, 0 to 1023, rows aligned with the other imager's.
using InfraredImage = Image<std::uint16_t>;

struct BlockMatchingOptions {
  int search_px = 126;        ///< largest disparity: the camera's, and so its least distance
  int window_px = 9;          ///< costs are summed over a square of this edge, odd
  int census_threshold = 20;  ///< levels by which a neighbour must be brighter to count: above the read noise
  double uniqueness = 0.03;   ///< the best cost must be lower than any other (apart from its neighbours) by
                              ///< this share; where there is no other, there is no match
  int left_right_px = 1;      ///< how far the match of the match may be from where it began
};

/// No match.
inline constexpr std::uint8_t no_match = 0;

/// Winner takes all over sums of census costs (Zabih and Woodfill, ECCV 1994), checked from right to left.
/// @param left, right of one size, at least as wide and high as the windows
/// @return disparity of each pixel of the left image, whole pixels, 1 to search_px, or `no_match`: what
///         the left imager sees at column u, the right one sees at u - disparity
[[nodiscard]] Image<std::uint8_t> match_blocks(const InfraredImage& left, const InfraredImage& right,
                                               const BlockMatchingOptions& options);

/// The census of each pixel: bit i is set where the i-th of 16 neighbours within 7 x 7 is brighter than the
/// pixel by more than the threshold. Outside the image, the nearest pixel counts.
[[nodiscard]] Image<std::uint16_t> census(const InfraredImage& image, int threshold);

}  // namespace rva
