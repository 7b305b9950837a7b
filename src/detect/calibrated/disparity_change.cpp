#include "detect/calibrated/disparity_change.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

constexpr int structure_window_px = 5;
constexpr float jump = 10.0F;  // in deviations of the median pixel
constexpr float nothing = 0.0F;

// Mean disparities, and variances of a frame added to `variance_px2`.
class Converter {
 public:
  Converter(const DepthStatistics& depth, double disparity_by_depth)
      : depth_(depth), disparity_by_depth_(disparity_by_depth), share_of_(depth.frames() + 1) {
    for (std::size_t count = 1; count < share_of_.size(); ++count)
      share_of_[count] = 1.0 / static_cast<double>(count);
  }

  // dd / dz = -d / z.
  void convert(std::size_t i, float& disparity_px, float& variance_px2) const {
    if (!depth_.seen(i)) return;
    const double share = share_of_[depth_.count(i)];
    const double mean = static_cast<double>(depth_.sum(i)) * share;
    const double disparity = disparity_by_depth_ / mean;
    const double slope = disparity * disparity / disparity_by_depth_ * share;
    disparity_px = static_cast<float>(disparity);
    variance_px2 += static_cast<float>(static_cast<double>(depth_.scaled_variance(i)) * slope * slope);
  }

 private:
  const DepthStatistics& depth_;
  double disparity_by_depth_;
  std::vector<double> share_of_;
};

// Range within the window; pixels without a disparity do not count.
Image<float> local_range(const Image<float>& disparity_px) {
  constexpr float far = std::numeric_limits<float>::max();
  Image<float> least = disparity_px;
  for (float& pixel : least.pixels()) pixel = pixel > nothing ? pixel : far;
  Image<float> range(disparity_px.width(), disparity_px.height());
  const cv::Mat window = cv::Mat::ones(structure_window_px, structure_window_px, CV_8U);
  cv::Mat range_pixels = as_mat(range);
  cv::dilate(as_mat(disparity_px), range_pixels, window);
  cv::Mat least_pixels = as_mat(least);
  cv::erode(least_pixels, least_pixels, window);
  for (std::size_t i = 0; i < range.size(); ++i) range[i] -= std::min(least[i], range[i]);
  return range;
}

void leave_out(DisparityChange& change, std::size_t i) {
  change.judged[i] = 0;
  change.deviation_px[i] = nothing;
}

void leave_out_margin(DisparityChange& change) {
  const int width = change.judged.width();
  const int height = change.judged.height();
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const bool inside = v >= margin_px && v < height - margin_px && u >= margin_px && u < width - margin_px;
      if (!inside) leave_out(change, static_cast<std::size_t>(&change.judged(u, v) - change.judged.data()));
    }
  }
}

void leave_out_jumps(DisparityChange& change) {
  constexpr std::size_t sampling = 7;
  std::vector<float> deviations_px;
  for (std::size_t i = 0; i < change.judged.size(); i += sampling) {
    if (change.judged[i] != 0) deviations_px.push_back(change.deviation_px[i]);
  }
  if (deviations_px.empty()) return;
  const float most_px = jump * quantile(deviations_px, 0.5);
  if (most_px <= 0.0F) return;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (change.deviation_px[i] > most_px) leave_out(change, i);
  }
}

}  // namespace

DisparityChange disparity_change(const DepthStatistics& initial, const DepthStatistics& final,
                                 double disparity_by_depth) {
  assert(initial.width() == final.width() && initial.height() == final.height());
  DisparityChange change(final.width(), final.height());
  const Converter before(initial, disparity_by_depth);
  const Converter after(final, disparity_by_depth);
  for (std::size_t i = 0; i < final.size(); ++i) {
    float variance_px2 = 0.0F;
    before.convert(i, change.before_px[i], variance_px2);
    after.convert(i, change.after_px[i], variance_px2);
    if (change.before_px[i] <= nothing || change.after_px[i] <= nothing) continue;
    change.judged[i] = mask_set;
    change.deviation_px[i] = std::sqrt(variance_px2);
  }
  leave_out_margin(change);
  leave_out_jumps(change);
  change.structure_px = local_range(change.before_px);
  const Image<float> structure_after = local_range(change.after_px);
  for (std::size_t i = 0; i < final.size(); ++i)
    change.structure_px[i] = std::min(change.structure_px[i], structure_after[i]);
  return change;
}

}  // namespace rva
