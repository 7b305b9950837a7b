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

constexpr std::size_t sampling = 17;  // sums over windows change little from pixel to pixel
// Evidence is summed as integers, which is exact and twice as fast as floating point.
constexpr double steps_per_deviation = 1024.0;

cv::Mat window_sums(const cv::Mat& values, int window_px) {
  cv::Mat sums;
  cv::boxFilter(values, sums, CV_32S, cv::Size(window_px, window_px), cv::Point(-1, -1), false,
                cv::BORDER_CONSTANT);
  return sums;
}

cv::Mat in_steps(const Image<float>& evidence) {
  cv::Mat steps;
  as_mat(evidence).convertTo(steps, CV_16S, steps_per_deviation);
  return steps;
}

/// Sums over windows, in deviations of a sum of independent pixels.
class Sums {
 public:
  Sums(const Image<float>& evidence, const Mask& judged, int window_px)
      : sums_(window_sums(in_steps(evidence), window_px)), counts_(window_sums(as_mat(judged), window_px)) {
    const int most = window_px * window_px;
    by_count_.push_back(0.0F);
    for (int count = 1; count <= most; ++count)
      by_count_.push_back(static_cast<float>(1.0 / (steps_per_deviation * std::sqrt(count))));
  }

  [[nodiscard]] int pixels(std::size_t i) const { return counts_.ptr<int>()[i] / mask_set; }
  [[nodiscard]] float deviations(std::size_t i) const {
    return static_cast<float>(sums_.ptr<int>()[i]) * by_count_[static_cast<std::size_t>(pixels(i))];
  }

 private:
  cv::Mat sums_;
  cv::Mat counts_;
  std::vector<float> by_count_;  // 1 / square root of the number of pixels
};

// Equation 16 of docs/math.md.
double spread_of(const Sums& sums, const Mask& pooled) {
  std::vector<float> sizes;
  for (std::size_t i = 0; i < pooled.size(); i += sampling) {
    if (pooled[i] != 0) sizes.push_back(std::abs(sums.deviations(i)));
  }
  const float deviation = sizes.empty() ? 0.0F : robust_deviation(sizes);
  return deviation > 0.0F ? static_cast<double>(deviation) : 1.0;
}

}  // namespace

// Equation 15 of docs/math.md.
PooledEvidence pool(const Image<float>& evidence, const Mask& judged, int window_px,
                    std::optional<double> spread) {
  PooledEvidence result{window_px, Image<float>(evidence.width(), evidence.height()),
                        Mask(evidence.width(), evidence.height()), 1.0};
  const Sums sums(evidence, judged, window_px);
  const int least = (window_px * window_px + 1) / 2;
  for (std::size_t i = 0; i < judged.size(); ++i)
    result.pooled[i] = sums.pixels(i) >= least ? judged[i] : std::uint8_t{0};
  result.spread = spread ? *spread : spread_of(sums, result.pooled);
  const auto scale = static_cast<float>(1.0 / result.spread);
  for (std::size_t i = 0; i < judged.size(); ++i)
    result.deviations[i] = result.pooled[i] != 0 ? scale * sums.deviations(i) : 0.0F;
  return result;
}

}  // namespace rva
