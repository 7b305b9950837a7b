#include "detect/calibrated/unreliable_pixels.hpp"

#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

constexpr int time_window_px = 9;
constexpr int hole_window_px = 17;  // a hole disturbs the matches within a window on each side of it
constexpr double steady_share = 0.8;
constexpr double most_missing = 0.02;
constexpr std::size_t sampling = 17;

float steady_px(const DisparityChange& change) {
  std::vector<float> deviations_px;
  for (std::size_t i = 0; i < change.judged.size(); i += sampling) {
    if (change.judged[i] != 0) deviations_px.push_back(change.deviation_px[i]);
  }
  return deviations_px.empty() ? 0.0F : quantile(deviations_px, steady_share);
}

// Share of the window's pixels that have a disparity, 0 to 255.
cv::Mat measured_around(const Image<float>& disparity_px) {
  cv::Mat around;
  cv::blur(as_mat(disparity_px) > 0.0, around, cv::Size(hole_window_px, hole_window_px));
  return around;
}

}  // namespace

Mask unreliable_pixels(const DisparityChange& change) {
  const float steady = steady_px(change);
  Image<float> excess(change.judged.width(), change.judged.height());
  for (std::size_t i = 0; i < excess.size(); ++i) {
    const float deviation_px = change.deviation_px[i];
    excess[i] = change.judged[i] != 0 ? deviation_px * deviation_px - steady * steady : 0.0F;
  }
  cv::Mat excess_around = as_mat(excess);
  cv::blur(excess_around, excess_around, cv::Size(time_window_px, time_window_px));
  const cv::Mat before = measured_around(change.before_px);
  const cv::Mat after = measured_around(change.after_px);
  const auto least = static_cast<std::uint8_t>((1.0 - most_missing) * mask_set);
  Mask unreliable(excess.width(), excess.height());
  for (std::size_t i = 0; i < unreliable.size(); ++i) {
    const bool missing = before.data[i] < least && after.data[i] < least;
    unreliable[i] = missing || excess[i] > 0.0F ? mask_set : std::uint8_t{0};
  }
  return unreliable;
}

}  // namespace rva
