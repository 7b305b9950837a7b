#include "detect/calibrated/pooled_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
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

// Sum over a window in deviations of independent pixels.
float in_deviations(float sum, float pixels) { return sum / std::sqrt(std::max(pixels, 1.0F)); }

}  // namespace

PooledEvidence pool(const Image<float>& evidence, const Mask& judged, int window_px) {
  PooledEvidence result{window_px, Image<float>(evidence.width(), evidence.height()),
                        Mask(evidence.width(), evidence.height()), 1.0};
  const cv::Mat sums = window_sums(as_mat(evidence), window_px);
  const cv::Mat counts = window_sums(as_mat(judged), window_px);
  const auto* const sum = sums.ptr<float>();
  const auto* const count = counts.ptr<float>();
  const float least = 0.5F * static_cast<float>(mask_set * window_px * window_px);
  for (std::size_t i = 0; i < judged.size(); ++i)
    result.pooled[i] = count[i] >= least ? judged[i] : std::uint8_t{0};

  std::vector<float> sizes;
  for (std::size_t i = 0; i < judged.size(); i += sampling) {
    if (result.pooled[i] != 0) sizes.push_back(std::abs(in_deviations(sum[i], count[i] / mask_set)));
  }
  const float deviation = sizes.empty() ? 0.0F : robust_deviation(sizes);
  if (deviation > 0.0F) result.agreement = static_cast<double>(deviation);
  const auto scale = static_cast<float>(1.0 / result.agreement);
  for (std::size_t i = 0; i < judged.size(); ++i) {
    const float value = scale * in_deviations(sum[i], count[i] / mask_set);
    result.deviations[i] = result.pooled[i] != 0 ? value : 0.0F;
  }
  return result;
}

}  // namespace rva
