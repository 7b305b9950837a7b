// From windows with significant evidence to the pixels that changed.
#pragma once

#include <array>

#include "detect/calibrated/scale.hpp"
#include "detect/regions/comparison.hpp"

namespace rva {

/// Marks changed pixels, scale by scale from fine to coarse. A change has its outline from the first scale at
/// which it is significant; coarser scales only make it rarer. The outline consists of the pixels with more
/// than half of the mean evidence of the window with the most evidence.
class Outlines {
 public:
  /// @param unreliable     as returned by unreliable_pixels(); must outlive this object
  /// @param tests      number of tails among which the false findings are divided, over all scales
  /// @param comparison its `changed`, `farther` and `evidence` (-log10 of the expected number of false
  ///                   findings as strong) are filled in; must outlive this object
  Outlines(const Mask& unreliable, double tests, Comparison& comparison);

  /// @param evidence evidence of single pixels, which the scale pooled
  void add(const Scale& scale, const Image<float>& evidence);

 private:
  void add(const Scale& scale, const Image<float>& evidence, float sign);

  const Mask& unreliable_;
  double log10_tests_;
  Comparison& comparison_;
  std::array<Mask, 2> outlined_;  // pixels that a scale has marked already: nearer, farther
};

}  // namespace rva
