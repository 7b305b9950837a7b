// Matching by differences of brightness in a window, the plainest of matchers.
#pragma once

#include <cstdint>

#include "depth/image.hpp"
#include "stereo/block_matching.hpp"

namespace rva {

struct CorrelationOptions {
  int window_px = 9;         ///< edge of the square, odd, at most 13
  int mean_px = 15;          ///< edge of the square whose mean is taken away from each pixel first, odd
  double uniqueness = 0.05;  ///< as in BlockMatchingOptions
  double least_texture =
      2.0;  ///< levels by which costs beside the best one must rise, for each pixel of the window
};

/// Sums of absolute differences of both images, local means apart (a band-pass, as usual before it), the
/// least of which wins; sub-pixel by a parabola, which draws answers towards whole pixels ("pixel locking").
/// @return disparity of each pixel of the left image in 1/32 px, 0 where there is no match
[[nodiscard]] Image<std::uint16_t> match_by_correlation(const InfraredImage& left, const InfraredImage& right,
                                                        const CorrelationOptions& options = {});

}  // namespace rva
