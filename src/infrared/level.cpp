#include "infrared/level.hpp"

#include <algorithm>
#include <cstddef>
#include <opencv2/imgproc.hpp>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"

namespace rva {

cv::Mat as_weights(const cv::Mat& mask) {
  cv::Mat weights;
  mask.convertTo(weights, CV_32F, 1.0 / mask_set);
  return weights;
}

cv::Mat window_mean(const cv::Mat& values, const cv::Mat& weights, int side_px) {
  cv::Mat sum;
  cv::Mat share;
  cv::blur(values.mul(weights), sum, {side_px, side_px});
  cv::blur(weights, share, {side_px, side_px});
  return sum / (share + 1e-6);
}

std::vector<float> sampled(const cv::Mat& values, const Mask& mask) {
  constexpr std::size_t every = 7;
  std::vector<float> samples;
  for (std::size_t i = 0; i < mask.size(); i += every) {
    if (mask[i] != 0) samples.push_back(values.ptr<float>()[i]);
  }
  return samples;
}

float deviation_of(const cv::Mat& values, const Mask& mask) {
  std::vector<float> sizes = sampled(cv::abs(values), mask);
  return sizes.empty() ? 0.0F : robust_deviation(sizes);
}

cv::Mat level_of(const cv::Mat& difference, const Mask& judged) {
  constexpr int narrow_px = 5;
  constexpr int wide_px = 81;
  constexpr float least_calm = 0.012F;
  constexpr float calm_deviations = 3.0F;
  std::vector<float> samples = sampled(difference, judged);
  const double median = samples.empty() ? 0.0 : static_cast<double>(quantile(samples, 0.5));
  const cv::Mat weights = as_weights(as_mat(judged));
  const cv::Mat about_median = difference - median;
  const cv::Mat local = window_mean(about_median, weights, narrow_px);
  const float calm = std::max(least_calm, calm_deviations * deviation_of(local, judged));
  const cv::Mat calm_weights = as_weights(cv::abs(local) < static_cast<double>(calm));
  return window_mean(about_median, weights.mul(calm_weights), wide_px) + median;
}

}  // namespace rva
