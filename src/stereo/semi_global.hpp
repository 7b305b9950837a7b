// Semi-global matching, as many other cameras' processors have it.
#pragma once

#include <cstdint>

#include "depth/image.hpp"
#include "stereo/block_matching.hpp"

namespace rva {

struct SemiGlobalOptions {
  int census_threshold = 20;  ///< as in BlockMatchingOptions
  int small_step = 2;         ///< penalty of a disparity that differs by one from its neighbour's
  int large_step = 24;        ///< of one that differs by more
  double uniqueness = 0.03;
};

/// Census costs (Zabih and Woodfill 1994), summed along four paths with penalties for steps (Hirschmueller,
/// PAMI 2008); sub-pixel by a parabola. It fills what has no dots from around it, and rounds corners.
/// @return disparity of each pixel of the left image in 1/32 px, 0 where there is no match
[[nodiscard]] Image<std::uint16_t> match_semi_globally(const InfraredImage& left, const InfraredImage& right,
                                                       const SemiGlobalOptions& options = {});

}  // namespace rva
