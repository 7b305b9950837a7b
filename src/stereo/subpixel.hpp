// Refines disparities to fractions of a pixel.
#pragma once

#include <cstdint>

#include "depth/image.hpp"
#include "stereo/block_matching.hpp"

namespace rva {

/// Settings of the refinement of disparities between whole pixels.
struct SubpixelOptions {
  int window_px = 11;        ///< edge of the fitted square, odd, at most 11; weights decrease towards it
  int steps = 3;             ///< number of Gauss-Newton steps
  int fraction_bits = 5;     ///< the result is rounded to 1 / 2^bits of a pixel
  double least_texture = 4;  ///< root mean square of the window's gradient along the row, levels per pixel
};

/// Finds, by least squares along the row, the shift at which the windows match best apart from their mean
/// brightness (Lucas and Kanade 1981, with the gradient of the left image and cubic interpolation of the
/// right one).
/// @param whole whole-pixel disparities of `left`, from match_blocks()
/// @return disparity in 1 / 2^fraction_bits px; 0 where there was no match, the window has too little
///         texture, or the result is more than a pixel from the start
[[nodiscard]] Image<std::uint16_t> refine_disparity(const InfraredImage& left, const InfraredImage& right,
                                                    const Image<std::uint8_t>& whole,
                                                    const SubpixelOptions& options);

}  // namespace rva
