// Semi-global matching, as used by the processors of many other cameras.
#pragma once

#include <cstdint>

#include "depth/image.hpp"
#include "stereo/block_matching.hpp"

namespace rva {

/// Settings of semi-global matching.
struct SemiGlobalOptions {
  int census_threshold = 20;  ///< as in BlockMatchingOptions
  int small_step = 2;         ///< penalty if a disparity differs by one from that of its neighbour
  int large_step = 24;        ///< penalty if it differs by more
  double uniqueness = 0.03;   ///< as in BlockMatchingOptions
};

/// Sums census costs (Zabih and Woodfill 1994) along four paths with penalties for steps (Hirschmueller, PAMI
/// 2008), refined by a parabola. It fills areas without dots from their surroundings, and rounds corners.
/// @return disparity of each pixel of the left image in 1/32 px, 0 where there is no match
[[nodiscard]] Image<std::uint16_t> match_semi_globally(const InfraredImage& left, const InfraredImage& right,
                                                       const SemiGlobalOptions& options = {});

}  // namespace rva
