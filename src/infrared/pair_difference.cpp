#include "infrared/pair_difference.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <span>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"
#include "infrared/level.hpp"

namespace rva {
namespace {

constexpr float border_px = 4.0F;

// Set at saturated dots and the pixels beside them, which do not show the surface.
Mask saturated(const InfraredView& view) {
  constexpr float nearly_white = 5.49F;  // the logarithm of 240 levels of 255
  Mask mask(view.dots.width(), view.dots.height());
  cv::Mat target = as_mat(mask);
  cv::dilate(as_mat(view.log_image) > static_cast<double>(nearly_white), target, cv::Mat::ones(3, 3, CV_8U));
  return mask;
}

Image<float> steepness_of(const cv::Mat& image) {
  constexpr double smoothing_px = 0.5;
  constexpr double per_px = 1.0 / 8.0;  // scale of Sobel's sums
  cv::Mat smooth;
  cv::GaussianBlur(image, smooth, {}, smoothing_px);
  cv::Mat along_u;
  cv::Mat along_v;
  cv::Sobel(smooth, along_u, CV_32F, 1, 0, 3, per_px);
  cv::Sobel(smooth, along_v, CV_32F, 0, 1, 3, per_px);
  Image<float> steepness(image.cols, image.rows);
  cv::Mat target = as_mat(steepness);
  cv::magnitude(along_u, along_v, target);
  return steepness;
}

// Change of brightness at a pixel due to texture that moved by the difference of both poses.
float moved_texture(const Image<float>& texture, int u, int v, const Eigen::Vector2f& shift) {
  const Eigen::Vector2f at(static_cast<float>(u) + shift.x(), static_cast<float>(v) + shift.y());
  const Eigen::Vector2f most(static_cast<float>(texture.width() - 1),
                             static_cast<float>(texture.height() - 1));
  return texture(u, v) - cubic_at(texture, at.cwiseMax(0.0F).cwiseMin(most));
}

}  // namespace

// Equation 60 of docs/math.md.
PairDifference pair_difference(const InfraredView& initial, const InfraredView& final,
                               const ReferenceSurface& surface, const Image<float>& texture) {
  const Warp warp(surface, final.view_from_reference);
  const ViewOfSurface final_view(surface, final.view_from_reference);
  const ViewOfSurface initial_view(surface, initial.view_from_reference);
  const Image<float> after = warp.image(final.log_image);
  const Image<float> before = warp.image(initial.log_image);
  const int width = after.width();
  const int height = after.height();
  PairDifference difference{Image<float>(width, height), Image<float>(width, height),
                            steepness_of(0.5 * (as_mat(before) + as_mat(after))),
                            warp.clear_of(saturated(final))};
  const Mask initial_clear = warp.clear_of(saturated(initial));
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      difference.brightness(u, v) = std::min(before(u, v), after(u, v));
      if (initial_clear(u, v) == 0 || !warp.inside(u, v, border_px)) difference.valid(u, v) = 0;
      if (difference.valid(u, v) == 0) continue;
      const Eigen::Vector2f shift = final_view.seen_at(u, v) - initial_view.seen_at(u, v);
      difference.change(u, v) = after(u, v) - before(u, v) - moved_texture(texture, u, v, shift);
    }
  }
  cv::Mat change = as_mat(difference.change);
  change -= level_of(change, difference.valid);
  cv::multiply(change, as_weights(as_mat(difference.valid)), change);
  return difference;
}

PixelNoise::PixelNoise(const std::vector<PairDifference>& differences) {
  constexpr std::size_t sampling = 7;
  constexpr std::size_t least_samples = 100;
  std::vector<std::vector<float>> sizes(kinds);
  for (const PairDifference& difference : differences) {
    for (std::size_t i = 0; i < difference.change.size(); i += sampling) {
      if (difference.valid[i] != 0) sizes[kind_of(difference, i)].push_back(std::abs(difference.change[i]));
    }
  }
  constexpr float unknown = 1.0F;  // larger than any learnt deviation
  constexpr float least = 1e-3F;   // for images that are exactly equal
  for (std::size_t kind = 0; kind < kinds; ++kind)
    deviation_[kind] =
        sizes[kind].size() < least_samples ? unknown : std::max(robust_deviation(sizes[kind]), least);
}

std::size_t PixelNoise::kind_of(const PairDifference& difference, std::size_t i) {
  const auto above = [](std::span<const float> bounds, float value) {
    return static_cast<std::size_t>(std::ranges::upper_bound(bounds, value) - bounds.begin());
  };
  return above(steep, difference.steepness[i]) * (bright.size() + 1) +
         above(bright, difference.brightness[i]);
}

}  // namespace rva
