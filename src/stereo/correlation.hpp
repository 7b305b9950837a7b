// Matching by absolute differences of brightness in a window, the simplest matcher.
#pragma once

#include <cstdint>

#include "depth/image.hpp"
#include "stereo/block_matching.hpp"

namespace rva {

/// Settings of block matching with correlation costs.
struct CorrelationOptions {
  int window_px = 9;         ///< edge of the square, odd, at most 13
  int mean_px = 15;          ///< edge of the square whose mean is subtracted from each pixel first, odd
  double uniqueness = 0.05;  ///< as in BlockMatchingOptions
  /// Least curvature of the costs at the best one, in grey levels per pixel of the window.
  double least_texture = 2.0;
};

/// Minimises sums of absolute differences of both images, after subtraction of local means (the usual
/// band-pass). The result is refined by a parabola, which biases it towards whole pixels ("pixel locking").
/// @return disparity of each pixel of the left image in 1/32 px, 0 where there is no match
[[nodiscard]] Image<std::uint16_t> match_by_correlation(const InfraredImage& left, const InfraredImage& right,
                                                        const CorrelationOptions& options = {});

}  // namespace rva
