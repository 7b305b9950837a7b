// Algorithm 3 of the thesis: a pixel has changed if its distributions before and after are far apart.
#pragma once

#include "core/options.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/regions/comparison.hpp"

namespace rva {

/// Options of the method `gaussian`.
struct GaussianOptions {
  double sigmas = 3.0;

  static void describe(auto&& self, auto&& visit) {
    visit(self.sigmas, OptionField{"sigmas", "", 0, 1000,
                                   "gaussian: standard deviations between either mean and its threshold"});
  }
};

/// A pixel has changed if t_f < t_i, with t_i = mean_i - sigmas * std_i and t_f = mean_f + sigmas * std_f
/// (equations 3.1 and 3.2).
///
/// Unlike in the thesis, mean and standard deviation are over valid measurements only, and a pixel is
/// compared if both sets saw it (DepthStatistics::seen()). It is computed in doubles as written, so that any
/// implementation of the equations gives the same result to the last bit. Evidence is the distance of the
/// means in standard deviations of the difference of two single frames, with the variance of rounding depth
/// to its unit added.
/// @param initial, final statistics before and after, of one size and depth unit; the deviation of a single
///                       frame is 0
/// @param unit_m         metres of one depth unit
/// @param left_out       pixels to leave out, see is_left_out()
[[nodiscard]] Comparison compare_gaussian(const DepthStatistics& initial, const DepthStatistics& final,
                                          double unit_m, const GaussianOptions& options,
                                          const Mask& left_out = {});

}  // namespace rva
