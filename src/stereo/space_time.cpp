#include "stereo/space_time.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "depth/mat_view.hpp"

namespace rva {
namespace {

Image<float> median_of_neighbours(const Image<float>& image) {
  constexpr int window_px = 5;
  Image<float> result(image.width(), image.height());
  cv::Mat target = as_mat(result);
  cv::medianBlur(as_mat(image), target, window_px);
  return result;
}

}  // namespace

ReferenceSurface refined(const ReferenceSurface& start, const StereoScale& stereo,
                         std::span<const StereoView> views, const SweepOptions& options) {
  constexpr float least_px = 0.01F;
  const auto scale = static_cast<float>(stereo.focal_baseline_m_px);
  const SweptCosts costs = sweep(start, stereo, views, options);
  Image<float> disparity = start.inverse_depth_per_m;
  for (int v = 0; v < disparity.height(); ++v) {
    for (int u = 0; u < disparity.width(); ++u) {
      disparity(u, v) *= scale;
      if (costs.freedom(u, v) > 0.0F) disparity(u, v) += costs.offset_px(minimum_of(costs.at(u, v)).label);
    }
  }
  ReferenceSurface result{start.camera, median_of_neighbours(disparity)};
  for (float& value : result.inverse_depth_per_m.pixels()) value = std::max(value, least_px) / scale;
  return result;
}

Image<float> space_time_disparity(const ReferenceSurface& start, const StereoScale& stereo,
                                  std::span<const StereoView> views, const SpaceTimeOptions& options) {
  const ReferenceSurface coarse = refined(start, stereo, views, options.coarse);
  const ReferenceSurface fine = refined(coarse, stereo, views, options.fine);
  Image<float> disparity(fine.inverse_depth_per_m.width(), fine.inverse_depth_per_m.height());
  const SweptCosts seen =
      sweep(fine, stereo, views, {.window_px = options.fine.window_px, .range_px = 0.0, .step_px = 1.0});
  for (std::size_t i = 0; i < disparity.size(); ++i) {
    if (seen.freedom[i] > 0.0F)
      disparity[i] = static_cast<float>(stereo.focal_baseline_m_px) * fine.inverse_depth_per_m[i];
  }
  return disparity;
}

}  // namespace rva
