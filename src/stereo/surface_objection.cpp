#include "stereo/surface_objection.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/parallel.hpp"
#include "depth/mat_view.hpp"
#include "infrared/level.hpp"

namespace rva {
namespace {

constexpr SweepOptions nearby{.window_px = 5, .range_px = 1.0, .step_px = 0.5};

/// The least costs of the pairs of one side about both surfaces.
struct SideCosts {
  Image<float> own;
  Image<float> other;
  Image<float> freedom;  // about the own surface; 0 where too few pairs see either surface
};

Image<float> least_costs(const SweptCosts& costs) {
  Image<float> least(costs.freedom.width(), costs.freedom.height());
  parallel_bands(least.height(), [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      for (int u = 0; u < least.width(); ++u) least(u, v) = minimum_of(costs.at(u, v)).cost;
    }
  });
  return least;
}

SideCosts costs_of(const ReferenceSurface& own, const ReferenceSurface& other, const StereoScale& stereo,
                   std::span<StereoView> pairs) {
  align_disparities(own, stereo, pairs);
  const SweptCosts about_own = sweep(own, stereo, pairs, nearby);
  const SweptCosts about_other = sweep(other, stereo, pairs, nearby);
  SideCosts costs{least_costs(about_own), least_costs(about_other), about_own.freedom};
  const float least = 0.1F * *std::ranges::max_element(costs.freedom.pixels());
  for (std::size_t i = 0; i < costs.freedom.size(); ++i) {
    if (std::min(costs.freedom[i], about_other.freedom[i]) < least) costs.freedom[i] = 0.0F;
  }
  return costs;
}

constexpr float least_noise = 1e-9F;

// The residual variance about the own surface around each pixel.
cv::Mat noise_of(const SideCosts& costs) {
  constexpr int noise_px = 15;
  const cv::Mat weights = as_weights(as_mat(costs.freedom) > 0.0);
  return window_mean(as_mat(costs.own), weights, noise_px) /
         window_mean(as_mat(costs.freedom), weights, noise_px);
}

// Equation 68 of docs/math.md.
Image<float> objection_of(const SideCosts& costs) {
  const cv::Mat noise = noise_of(costs);
  Image<float> variances(noise.cols, noise.rows);
  for (std::size_t i = 0; i < variances.size(); ++i) {
    const float excess = costs.other[i] - costs.own[i];
    if (costs.freedom[i] > 0.0F && excess > 0.0F)
      variances[i] = excess / std::max(noise.ptr<float>()[i], least_noise);
  }
  return variances;
}

Image<float> least_within_a_pixel(const Image<float>& variances) {
  Image<float> least(variances.width(), variances.height());
  cv::Mat target = as_mat(least);
  cv::erode(as_mat(variances), target, cv::Mat::ones(3, 3, CV_8U));
  return least;
}

}  // namespace

SurfaceObjection surface_objection(const ReferenceSurface& surface_before,
                                   const ReferenceSurface& surface_after, const StereoScale& stereo,
                                   std::span<StereoView> before, std::span<StereoView> after) {
  const SideCosts of_before = costs_of(surface_before, surface_after, stereo, before);
  const SideCosts of_after = costs_of(surface_after, surface_before, stereo, after);
  const Image<float> by_before = objection_of(of_before);
  const Image<float> by_after = objection_of(of_after);
  const Image<float> by_before_nearby = least_within_a_pixel(by_before);
  const Image<float> by_after_nearby = least_within_a_pixel(by_after);
  const int width = by_before.width();
  const int height = by_before.height();
  SurfaceObjection objection{Image<float>(width, height), Image<float>(width, height), Mask(width, height)};
  for (std::size_t i = 0; i < objection.judged.size(); ++i) {
    if (of_before.freedom[i] <= 0.0F || of_after.freedom[i] <= 0.0F) continue;
    objection.judged[i] = mask_set;
    objection.variances[i] = std::min(by_before[i], by_after[i]);
    objection.variances_nearby[i] = std::min(by_before_nearby[i], by_after_nearby[i]);
  }
  return objection;
}

}  // namespace rva
