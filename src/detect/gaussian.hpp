// Algorithm 3 of the thesis: a pixel changed when the distributions before and after are far apart.
#pragma once

#include "core/options.hpp"
#include "depth/depth_statistics.hpp"
#include "detect/comparison.hpp"

namespace rva {

struct GaussianOptions {
  double sigmas = 3.0;

  static void describe(auto&& self, auto&& visit) {
    visit(self.sigmas, OptionField{"sigmas", "", 0, 1000,
                                   "gaussian: standard deviations between either mean and its threshold"});
  }
};

/// t_f < t_i with t_i = mean_i - sigmas * std_i and t_f = mean_f + sigmas * std_f (equations 3.1 and 3.2).
///
/// Unlike in the thesis, mean and deviation are over valid measurements only, and a pixel is compared where
/// both sets saw it (DepthStatistics::seen()). Computed in doubles as written, so that any implementation
/// that follows the equations agrees to the last bit. Evidence is the distance of the means in standard
/// deviations of one frame of either set, with the rounding of depth to its unit as the least deviation.
/// @param initial, final one size, one depth unit; deviations of a single frame are 0
/// @param unit_m         metres of one depth unit
/// @param left_out       as of is_left_out()
[[nodiscard]] Comparison compare_gaussian(const DepthStatistics& initial, const DepthStatistics& final,
                                          double unit_m, const GaussianOptions& options,
                                          const Mask& left_out = {});

}  // namespace rva
