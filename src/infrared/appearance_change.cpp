#include "infrared/appearance_change.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

constexpr int window_px = 5;
constexpr int wide_px = 81;
constexpr std::size_t sampling = 7;

Mask judged_pixels(const DotFreeImage& a, const DotFreeImage& b, const Mask& lit) {
  Mask judged(lit.width(), lit.height());
  for (std::size_t i = 0; i < lit.size(); ++i) {
    const bool both = a.known(i) && b.known(i) && a.variance[i] > 0.0F && b.variance[i] > 0.0F;
    judged[i] = both ? lit[i] : std::uint8_t{0};
  }
  return judged;
}

cv::Mat window_mean(const cv::Mat& values, const cv::Mat& weights, int side_px) {
  cv::Mat sum;
  cv::Mat share;
  cv::blur(values.mul(weights), sum, {side_px, side_px});
  cv::blur(weights, share, {side_px, side_px});
  return sum / (share + 1e-6);
}

cv::Mat as_weights(const Mask& mask) {
  cv::Mat weights;
  as_mat(mask).convertTo(weights, CV_32F, 1.0 / mask_set);
  return weights;
}

std::vector<float> sampled(const cv::Mat& values, const Mask& judged) {
  std::vector<float> samples;
  for (std::size_t i = 0; i < judged.size(); i += sampling) {
    if (judged[i] != 0) samples.push_back(values.ptr<float>()[i]);
  }
  return samples;
}

float median_of(const cv::Mat& values, const Mask& judged) {
  std::vector<float> samples = sampled(values, judged);
  return samples.empty() ? 0.0F : quantile(samples, 0.5);
}

float deviation_of(const cv::Mat& values, const Mask& judged) {
  std::vector<float> sizes = sampled(cv::abs(values), judged);
  return sizes.empty() ? 0.0F : robust_deviation(sizes);
}

// What the whole image and wide windows of calm pixels differ by. Windows around things that changed lean on
// what is calm beside them.
cv::Mat level_between(const cv::Mat& difference, const Mask& judged) {
  constexpr float least_calm = 0.012F;
  constexpr float calm_deviations = 3.0F;
  const cv::Mat weights = as_weights(judged);
  const float median = median_of(difference, judged);
  const cv::Mat about_median = difference - static_cast<double>(median);
  const cv::Mat local = window_mean(about_median, weights, window_px);
  const float calm = std::max(least_calm, calm_deviations * deviation_of(local, judged));
  cv::Mat calm_weights;
  cv::Mat(cv::abs(local) < static_cast<double>(calm)).convertTo(calm_weights, CV_32F, 1.0 / mask_set);
  return window_mean(about_median, weights.mul(calm_weights), wide_px) + static_cast<double>(median);
}

/// The least and the greatest value within half a pixel.
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

// What either image has beyond the other's range; the lesser of both, where they agree in sign.
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

AppearanceChange appearance_change(const DotFreeImage& initial, const DotFreeImage& final, const Mask& lit) {
  constexpr float least_pixels = 13.0F;  // of the window
  const Mask judged = judged_pixels(initial, final, lit);
  const cv::Mat weights = as_weights(judged);
  const Image<float> before = without_gaps(initial);
  const Image<float> after = without_gaps(final);
  const cv::Mat difference = as_mat(after) - as_mat(before);
  const cv::Mat level = level_between(difference, judged);
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
  // Neighbours share noise through interpolation and lenses: how much, the unchanged bulk of the image shows.
  const float agreement = std::max(deviation_of(as_mat(bulk), change.judged), 1.0F);
  for (float& deviations : change.deviations.pixels()) deviations /= agreement;
  return change;
}

}  // namespace rva
