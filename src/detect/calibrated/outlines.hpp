// From places that show too much evidence to the pixels that changed.
#pragma once

#include <array>

#include "detect/calibrated/scale.hpp"
#include "detect/comparison.hpp"

namespace rva {

/// Marks what the scales saw, from fine to coarse: a change has its outline from the first scale that saw it,
/// later ones only make it rarer. The outline are the pixels with half of the mean evidence of the window
/// that shows most.
class Outlines {
 public:
  /// @param unsure     as of unsure_places()
  /// @param looks      tails that share the false findings, over all scales
  /// @param comparison its `changed`, `farther` and `evidence`, -log10 of the expected false findings as
  /// strong, are
  ///                   filled
  Outlines(const Mask& unsure, double looks, Comparison& comparison);

  /// @param evidence of single pixels, which the scale pooled
  void add(const Scale& scale, const Image<float>& evidence);

 private:
  void add(const Scale& scale, const Image<float>& evidence, float sign);

  const Mask& unsure_;
  double log10_looks_;
  Comparison& comparison_;
  std::array<Mask, 2> outlined_;  // nearer, farther
};

}  // namespace rva
