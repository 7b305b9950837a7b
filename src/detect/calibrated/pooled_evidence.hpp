// Evidence pooled over neighbouring pixels: a collar affects one window of the matcher, a rag a tenth of
// the image.
#pragma once

#include <optional>

#include "depth/image.hpp"

namespace rva {

/// The sum of evidence over a square window around each pixel, in units of its own robust deviation.
struct PooledEvidence {
  int window_px = 0;
  Image<float> deviations;  ///< positive where nearer; 0 where too little of the window was judged
  Mask pooled;              ///< set where the pixel itself and at least half of the window were judged
  /// Ratio of the deviation of the pooled evidence to that of as many independent pixels: it grows with the
  /// correlation of neighbouring pixels.
  double spread = 1.0;
};

/// Pools evidence over square windows.
/// @param evidence  evidence of single pixels, with variance 1 and expectation 0 where nothing changed, -31
///                  to 31; 0 where not judged
/// @param spread see PooledEvidence; learnt from the image if it is not given
[[nodiscard]] PooledEvidence pool(const Image<float>& evidence, const Mask& judged, int window_px,
                                  std::optional<double> spread = {});

}  // namespace rva
