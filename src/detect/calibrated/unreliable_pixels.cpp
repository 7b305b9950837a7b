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
constexpr int most_missing = 7;  // of the 289 pixels of that window
constexpr std::size_t sampling = 17;

float steady_px(const DisparityChange& change) {
  std::vector<float> deviations_px;
  for (std::size_t i = 0; i < change.judged.size(); i += sampling) {
    if (change.judged[i] != 0) deviations_px.push_back(change.deviation_px[i]);
  }
  return deviations_px.empty() ? 0.0F : quantile(deviations_px, steady_share);
}

// The number of the window's pixels that have no disparity.
cv::Mat missing_around(const Image<float>& disparity_px) {
  cv::Mat around;
  const cv::Mat missing = (as_mat(disparity_px) <= 0.0) / mask_set;
  cv::boxFilter(missing, around, CV_32S, cv::Size(hole_window_px, hole_window_px), cv::Point(-1, -1), false);
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
  const cv::Mat missing =
      (missing_around(change.before_px) > most_missing) & (missing_around(change.after_px) > most_missing);
  Mask unreliable(excess.width(), excess.height());
  for (std::size_t i = 0; i < unreliable.size(); ++i)
    unreliable[i] = missing.data[i] != 0 || excess[i] > 0.0F ? mask_set : std::uint8_t{0};
  return unreliable;
}

}  // namespace rva
