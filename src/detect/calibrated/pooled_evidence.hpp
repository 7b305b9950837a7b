// Evidence of neighbours together: a collar spoils a window of the matcher, a rag a tenth of the image.
#pragma once

#include <optional>

#include "depth/image.hpp"

namespace rva {

/// The sum of evidence over a square window around each pixel, in its own robust deviations.
struct PooledEvidence {
  int window_px = 0;
  Image<float> deviations;  ///< above 0 for what came nearer; 0 where too little of the window was judged
  Mask pooled;              ///< set where at least half of the window was judged, and the pixel itself
  /// How much larger a pooled deviation is than that of as many independent pixels: what neighbours agree.
  double agreement = 1.0;
};

/// @param evidence of single pixels, of variance 1 and expectation 0 where nothing changed, -31 to 31; 0
/// where
///                 not judged
/// @param agreement learnt where it is not given
[[nodiscard]] PooledEvidence pool(const Image<float>& evidence, const Mask& judged, int window_px,
                                  std::optional<double> agreement = {});

}  // namespace rva
