// Disparity between whole pixels.
#pragma once

#include <cstdint>

#include "depth/image.hpp"
#include "stereo/block_matching.hpp"

namespace rva {

struct SubpixelOptions {
  int window_px = 11;        ///< edge of the square that is fitted, odd, at most 11; weights fade towards it
  int steps = 3;             ///< of Gauss and Newton
  int fraction_bits = 5;     ///< the answer is rounded to 1 / 2^bits of a pixel
  double least_texture = 4;  ///< root mean square of the window's gradient along the row, levels per pixel
};

/// Least squares along the row: the shift between the windows, mean brightness apart, at which they agree
/// best (Lucas and Kanade 1981, with the left image's gradient; the right one interpolated by cubics).
/// @param whole whole-pixel disparities of `left`, from match_blocks()
/// @return disparity in 1 / 2^fraction_bits px; 0 where there was no match, the window has too little
///         texture to tell, or the answer is more than a pixel away from where it began
[[nodiscard]] Image<std::uint16_t> refine_disparity(const InfraredImage& left, const InfraredImage& right,
                                                    const Image<std::uint8_t>& whole,
                                                    const SubpixelOptions& options);

}  // namespace rva
