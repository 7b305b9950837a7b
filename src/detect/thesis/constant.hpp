// Algorithm 2 of the thesis: a pixel has changed if it came nearer by more than a constant.
#pragma once

#include "core/options.hpp"
#include "depth/image.hpp"
#include "detect/regions/comparison.hpp"

namespace rva {

/// Options of the method `constant`.
struct ConstantOptions {
  double threshold_m = 0.05;
  double clip_m = 2.0;

  static void describe(auto&& self, auto&& visit) {
    visit(self.threshold_m, OptionField{"threshold", "m", 0, 100,
                                        "constant: a pixel changed when it came nearer by more than this"});
    visit(self.clip_m,
          OptionField{"clip", "m", 0, 1000, "constant: pixels at this distance and beyond are left out"});
  }
};

/// A pixel has changed if initial - final > threshold and final < clip (thesis chapter 3.2.2).
///
/// Unlike in the thesis, a pixel without a measurement in either image never counts as changed. Evidence is
/// the decrease of depth, as a multiple of the threshold.
/// @param initial, final depth before and after, of one size and depth unit
/// @param unit_m         metres of one depth unit
/// @param left_out       pixels to leave out, see is_left_out()
[[nodiscard]] Comparison compare_constant(const DepthImage& initial, const DepthImage& final, double unit_m,
                                          const ConstantOptions& options, const Mask& left_out = {});

}  // namespace rva
