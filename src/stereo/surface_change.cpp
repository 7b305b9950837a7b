#include "stereo/surface_change.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "depth/mat_view.hpp"
#include "infrared/level.hpp"
#include "stereo/space_time.hpp"

namespace rva {
namespace {

constexpr SweepOptions coarse{.window_px = 5, .range_px = 4.0, .step_px = 0.5};
constexpr SweepOptions fine{.window_px = 5, .range_px = 2.0, .step_px = 0.25};
constexpr int mean_px = 5;
static_assert(surface_window_px == fine.window_px + mean_px - 1);

// The surface that explains the pairs of both sides together; every second pair of each side suffices.
ReferenceSurface common_surface(const ReferenceSurface& start, const StereoScale& stereo,
                                std::span<const StereoView> before, std::span<const StereoView> after) {
  std::vector<StereoView> some;
  for (const auto side : {before, after}) {
    for (std::size_t k = 0; k < side.size(); k += 2) some.push_back(side[k]);
  }
  return refined(start, stereo, some, coarse);
}

/// The comparison of one pixel's costs.
struct Ratio {
  float objection = 0.0F;  // excess of the common minimum over the sum of the separate ones
  float residual = 0.0F;   // sum of the separate minima
  float nearer_labels = 0.0F;
  float rise = 0.0F;  // objection for surfaces one label apart
};

// Equations 63 and 64 of docs/math.md.
Ratio ratio_of(std::span<const float> before, std::span<const float> after, std::vector<float>& both) {
  for (std::size_t label = 0; label < before.size(); ++label) both[label] = before[label] + after[label];
  const Minimum of_before = minimum_of(before);
  const Minimum of_after = minimum_of(after);
  const float own = of_before.cost + of_after.cost;
  // The minimum of the sum of two parabolas whose minima are one label apart.
  const float rises = of_before.rise + of_after.rise;
  const float rise = rises > 0.0F ? of_before.rise * of_after.rise / rises : 0.0F;
  return {.objection = std::max(minimum_of(both).cost - own, 0.0F),
          .residual = own,
          .nearer_labels = of_after.label - of_before.label,
          .rise = rise};
}

/// The quantities of Ratio at each pixel.
struct Ratios {
  Ratios(int width, int height)
      : objection(width, height),
        residual(width, height),
        freedom(width, height),
        nearer_px(width, height),
        rise_per_px2(width, height),
        judged(width, height) {}

  Image<float> objection;
  Image<float> residual;
  Image<float> freedom;
  Image<float> nearer_px;
  Image<float> rise_per_px2;
  Mask judged;
};

// Half of the degrees of freedom of a pixel that all pairs see.
float least_freedom(const SweptCosts& costs) {
  return std::max(0.5F * *std::ranges::max_element(costs.freedom.pixels()), 1.0F);
}

Ratios ratios_of(const SweptCosts& before, const SweptCosts& after) {
  Ratios ratios(before.freedom.width(), before.freedom.height());
  const float least_before = least_freedom(before);
  const float least_after = least_freedom(after);
  const float label_px = before.offset_px(1.0F) - before.offset_px(0.0F);
  parallel_bands(before.freedom.height(), [&](int first, int end) {
    std::vector<float> both(static_cast<std::size_t>(before.labels()));
    for (int v = first; v < end; ++v) {
      for (int u = 0; u < before.freedom.width(); ++u) {
        if (before.freedom(u, v) < least_before || after.freedom(u, v) < least_after) continue;
        const Ratio ratio = ratio_of(before.at(u, v), after.at(u, v), both);
        ratios.judged(u, v) = mask_set;
        ratios.nearer_px(u, v) = label_px * ratio.nearer_labels;
        ratios.rise_per_px2(u, v) = ratio.rise / (label_px * label_px);
        ratios.objection(u, v) = ratio.objection;
        ratios.residual(u, v) = ratio.residual;
        ratios.freedom(u, v) = before.freedom(u, v) + after.freedom(u, v);
      }
    }
  });
  return ratios;
}

// Converts ratios to deviations. The square root of the objection over the noise of its surroundings is a
// deviation. It is larger since neighbouring pixels share windows; the unchanged majority of the image shows
// by how much.
// Equations 65 and 66 of docs/math.md.
SurfaceChange weighed(Ratios ratios) {
  constexpr int noise_px = 15;
  constexpr float least_noise = 1e-9F;
  const cv::Mat weights = as_weights(as_mat(ratios.judged));
  const cv::Mat objection = window_mean(as_mat(ratios.objection), weights, mean_px);
  const cv::Mat rise = window_mean(as_mat(ratios.rise_per_px2), weights, mean_px);
  const cv::Mat nearer = window_mean(as_mat(ratios.nearer_px), weights, mean_px);
  const cv::Mat noise = window_mean(as_mat(ratios.residual), weights, noise_px) /
                        window_mean(as_mat(ratios.freedom), weights, noise_px);
  SurfaceChange change;
  change.deviations = Image<float>(ratios.judged.width(), ratios.judged.height());
  change.deviations_per_px = change.deviations;
  for (std::size_t i = 0; i < ratios.judged.size(); ++i) {
    if (ratios.judged[i] == 0) continue;
    const float variance = std::max(noise.ptr<float>()[i], least_noise);
    change.deviations[i] =
        std::copysign(std::sqrt(objection.ptr<float>()[i] / variance), nearer.ptr<float>()[i]);
    change.deviations_per_px[i] = std::sqrt(rise.ptr<float>()[i] / variance);
  }
  const float unit = deviation_of(as_mat(change.deviations), ratios.judged);
  for (Image<float>* const image : {&change.deviations, &change.deviations_per_px}) {
    for (float& value : image->pixels()) value = unit > 0.0F ? value / unit : 0.0F;
  }
  change.nearer_px = std::move(ratios.nearer_px);
  change.judged = std::move(ratios.judged);
  return change;
}

}  // namespace

SurfaceChange surface_change(const ReferenceSurface& start, const StereoScale& stereo,
                             std::span<StereoView> before, std::span<StereoView> after) {
  align_disparities(start, stereo, before);
  align_disparities(start, stereo, after);
  const ReferenceSurface common = common_surface(start, stereo, before, after);
  return weighed(ratios_of(sweep(common, stereo, before, fine), sweep(common, stereo, after, fine)));
}

}  // namespace rva
