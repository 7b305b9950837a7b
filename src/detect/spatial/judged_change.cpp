#include "detect/spatial/judged_change.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "depth/mat_view.hpp"

namespace rva {

// Where dots leave few samples, there are more and higher ones.
std::vector<float> peaks_of(const AppearanceChange& change) {
  constexpr int apart_px = 11;
  constexpr int beside_px = 31;
  constexpr double beyond_doubt = 7.0;
  const cv::Mat sizes = cv::abs(as_mat(change.deviations));
  cv::Mat highest;
  cv::dilate(sizes, highest, cv::Mat::ones(apart_px, apart_px, CV_8U));
  cv::Mat beside;
  cv::dilate(sizes > beyond_doubt, beside, cv::Mat::ones(beside_px, beside_px, CV_8U));
  std::vector<float> peaks;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    const float size = sizes.ptr<float>()[i];
    const bool is_peak = size > static_cast<float>(FalseAlarmTail::onset) && size >= highest.ptr<float>()[i];
    if (is_peak && change.judged[i] != 0 && beside.data[i] == 0) peaks.push_back(size);
  }
  return peaks;
}

void drop_faint(AppearanceChange& change, float least) {
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (std::abs(change.contrast[i]) <= least) change.deviations[i] = 0.0F;
  }
}

JudgedChange with_tail(AppearanceChange change, const TailPrior& prior, SurfaceChange surface) {
  const FalseAlarmTail tail = fit_tail(peaks_of(change), prior.slope, prior.end);
  return {std::move(change), tail, std::move(surface)};
}

}  // namespace rva
