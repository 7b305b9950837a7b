#include "detect/calibrated/pooled_evidence.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

constexpr std::size_t sampling = 7;  // sums over windows hardly differ from pixel to pixel

cv::Mat window_sums(const cv::Mat& values, int window_px) {
  cv::Mat sums;
  cv::boxFilter(values, sums, CV_32F, cv::Size(window_px, window_px), cv::Point(-1, -1), false,
                cv::BORDER_CONSTANT);
  return sums;
}

double robust_deviation(const PooledEvidence& evidence) {
  std::vector<float> sizes;
  for (std::size_t i = 0; i < evidence.pooled.size(); i += sampling) {
    if (evidence.pooled[i] != 0) sizes.push_back(std::abs(evidence.deviations[i]));
  }
  return sizes.empty() ? 0.0 : normal_per_median * static_cast<double>(quantile(sizes, 0.5));
}

}  // namespace

PooledEvidence pool(const Image<float>& evidence, const Mask& judged, int window_px) {
  PooledEvidence result{window_px, Image<float>(evidence.width(), evidence.height()),
                        Mask(evidence.width(), evidence.height()), 1.0};
  const cv::Mat sums = window_sums(as_mat(evidence), window_px);
  const cv::Mat counts = window_sums(as_mat(judged), window_px);
  const float least = 0.5F * static_cast<float>(window_px * window_px);
  for (int v = 0; v < evidence.height(); ++v) {
    const float* const sum = sums.ptr<float>(v);
    const float* const count = counts.ptr<float>(v);
    for (int u = 0; u < evidence.width(); ++u) {
      const float pixels = count[u] / mask_set;
      if (judged(u, v) == 0 || pixels < least) continue;
      result.pooled(u, v) = mask_set;
      result.deviations(u, v) = sum[u] / std::sqrt(pixels);
    }
  }
  const double deviation = robust_deviation(result);
  if (deviation <= 0.0) return result;
  result.agreement = deviation;
  for (float& value : result.deviations.pixels()) value /= static_cast<float>(deviation);
  return result;
}

}  // namespace rva
