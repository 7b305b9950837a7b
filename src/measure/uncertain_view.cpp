#include "measure/uncertain_view.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rva {
namespace {

/// Frames of one pose are not independent: their mean has the variance of at most this many.
constexpr double most_independent_frames = 4.0;

// Equation 75 of docs/math.md, in square pixels of disparity.
double variance_px2(const DepthStatistics& depth, std::size_t i, double units_px,
                    const MeasureOptions& options) {
  const double mean = depth.mean(i);
  const double px_per_unit = units_px / (mean * mean);
  const double n = depth.count(i);
  const double rounding_px2 = px_per_unit * px_per_unit / 12.0;
  const double fixed_px2 = std::max(options.matching_px * options.matching_px, rounding_px2);
  if (n < 2.0) return fixed_px2 + options.frame_px * options.frame_px;
  const double deviation_px = depth.standard_deviation(i) * px_per_unit;
  const double sample_px2 = deviation_px * deviation_px * n / (n - 1.0);
  return fixed_px2 + sample_px2 / std::min(n, most_independent_frames);
}

double overlap(double apart_px, double width_px) {
  return std::max(0.0, 1.0 - std::abs(apart_px) / width_px);
}

}  // namespace

double UncertainView::correlation(double du, double dv) const {
  return overlap(du, correlation_px) * overlap(dv, correlation_px);
}

UncertainView uncertain_view(const DepthStatistics& depth, const Intrinsics& camera,
                             const StereoScale& stereo, const MeasureOptions& options) {
  assert(depth.width() == camera.width && depth.height() == camera.height);
  UncertainView view{camera, stereo, Image<float>(camera.width, camera.height),
                     Image<float>(camera.width, camera.height), options.correlation_px};
  const double units_px = stereo.focal_baseline_units_px();
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (!depth.seen(i)) continue;
    view.disparity_px[i] = static_cast<float>(units_px / depth.mean(i));
    view.uncertainty_px[i] = static_cast<float>(std::sqrt(variance_px2(depth, i, units_px, options)));
  }
  return view;
}

}  // namespace rva
