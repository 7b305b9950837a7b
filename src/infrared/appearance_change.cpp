#include "infrared/appearance_change.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "depth/mat_view.hpp"
#include "infrared/level.hpp"

namespace rva {
namespace {

constexpr int window_px = 5;

Mask judged_pixels(const DotFreeImage& a, const DotFreeImage& b, const Mask& lit) {
  Mask judged(lit.width(), lit.height());
  for (std::size_t i = 0; i < lit.size(); ++i) {
    const bool both = a.known(i) && b.known(i) && a.variance[i] > 0.0F && b.variance[i] > 0.0F;
    judged[i] = both ? lit[i] : std::uint8_t{0};
  }
  return judged;
}

/// The least and the greatest value of an image within half a pixel.
struct Range {
  cv::Mat least;
  cv::Mat most;
};

Range within_half_a_pixel(const cv::Mat& image) {
  Range range{image.clone(), image.clone()};
  for (const double du : {-0.5, 0.0, 0.5}) {
    for (const double dv : {-0.5, 0.0, 0.5}) {
      const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1.0, 0.0, du, 0.0, 1.0, dv);
      cv::Mat shifted;
      cv::warpAffine(image, shifted, shift, image.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
      range.least = cv::min(range.least, shifted);
      range.most = cv::max(range.most, shifted);
    }
  }
  return range;
}

float beyond(float value, float least, float most) {
  return value > most ? value - most : std::min(value - least, 0.0F);
}

// By how much either image exceeds the range of the other; the smaller of both if they have the same
// direction, else 0.
// Equation 58 of docs/math.md.
Image<float> beyond_misregistration(const cv::Mat& before, const cv::Mat& after) {
  const Range range_before = within_half_a_pixel(before);
  const Range range_after = within_half_a_pixel(after);
  Image<float> excess(before.cols, before.rows);
  for (std::size_t i = 0; i < excess.size(); ++i) {
    const float after_beyond =
        beyond(after.ptr<float>()[i], range_before.least.ptr<float>()[i], range_before.most.ptr<float>()[i]);
    const float before_beyond =
        -beyond(before.ptr<float>()[i], range_after.least.ptr<float>()[i], range_after.most.ptr<float>()[i]);
    if (after_beyond * before_beyond <= 0.0F) continue;
    excess[i] = std::abs(after_beyond) < std::abs(before_beyond) ? after_beyond : before_beyond;
  }
  return excess;
}

}  // namespace

// Equation 59 of docs/math.md.
AppearanceChange appearance_change(const DotFreeImage& initial, const DotFreeImage& final, const Mask& lit) {
  constexpr float least_pixels = 13.0F;  // of the window
  const Mask judged = judged_pixels(initial, final, lit);
  const cv::Mat weights = as_weights(as_mat(judged));
  const Image<float> before = without_gaps(initial);
  const Image<float> after = without_gaps(final);
  const cv::Mat difference = as_mat(after) - as_mat(before);
  const cv::Mat level = level_of(difference, judged);
  const cv::Mat levelled = as_mat(after) - level;
  const Image<float> excess = beyond_misregistration(as_mat(before), levelled);

  cv::Mat count;
  cv::boxFilter(weights, count, CV_32F, {window_px, window_px}, {-1, -1}, false);
  const cv::Mat contrast = window_mean(as_mat(excess), weights, window_px);
  const cv::Mat plain = window_mean(levelled - as_mat(before), weights, window_px);
  const cv::Mat variance = window_mean(as_mat(initial.variance) + as_mat(final.variance), weights, window_px);
  AppearanceChange change{Image<float>(lit.width(), lit.height()), Image<float>(lit.width(), lit.height()),
                          Mask(lit.width(), lit.height())};
  Image<float> bulk(lit.width(), lit.height());
  for (std::size_t i = 0; i < judged.size(); ++i) {
    const float n = count.ptr<float>()[i];
    if (judged[i] == 0 || n < least_pixels) continue;
    change.judged[i] = mask_set;
    const float deviation = std::sqrt(variance.ptr<float>()[i] / n);
    change.contrast[i] = contrast.ptr<float>()[i];
    change.deviations[i] = change.contrast[i] / deviation;
    bulk[i] = plain.ptr<float>()[i] / deviation;
  }
  // Noise of neighbouring pixels is correlated by interpolation and lenses. The unchanged majority of the
  // image shows by how much that increases the deviation.
  const float spread = std::max(deviation_of(as_mat(bulk), change.judged), 1.0F);
  for (float& deviations : change.deviations.pixels()) deviations /= spread;
  return change;
}

}  // namespace rva
