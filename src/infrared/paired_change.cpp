#include "infrared/paired_change.hpp"

#include <algorithm>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <span>
#include <utility>

#include "core/parallel.hpp"
#include "depth/mat_view.hpp"
#include "geometry/rigid_motion.hpp"
#include "infrared/level.hpp"
#include "infrared/pair_difference.hpp"
#include "infrared/projector_field.hpp"

namespace rva {
namespace {

constexpr int window_px = 5;
constexpr std::size_t least_pairs = 3;

struct Pair {
  const InfraredView* initial;
  const InfraredView* final;
};

double turn_deg(const InfraredView& a, const InfraredView& b) {
  const Transform motion = a.view_from_reference * b.view_from_reference.inverse();
  return angle_deg_of(motion);
}

// Pairs of views of nearly one pose. Servos come to rest within half a step of their target, in either
// direction and in both joints: 0.46 degrees in total.
std::vector<Pair> pairs_of(const std::vector<InfraredView>& initial, const std::vector<InfraredView>& final) {
  constexpr double nearly_one_pose_deg = 0.6;
  std::vector<Pair> pairs;
  for (const InfraredView& view : final) {
    const auto nearest = std::ranges::min_element(
        initial, {}, [&](const InfraredView& candidate) { return turn_deg(candidate, view); });
    if (nearest != initial.end() && turn_deg(*nearest, view) < nearly_one_pose_deg)
      pairs.push_back({&*nearest, &view});
  }
  return pairs;
}

/// Evidence of one pair in the window around each pixel.
struct PairEvidence {
  cv::Mat deviations;  ///< sum over the window, in deviations
  cv::Mat contrast;    ///< mean over the window
  cv::Mat pixels;      ///< number of valid pixels of the window
};

PairEvidence evidence_of(const PairDifference& difference, const PixelNoise& noise) {
  constexpr float most_deviations = 4.0F;
  Image<float> clipped(difference.change.width(), difference.change.height());
  for (std::size_t i = 0; i < clipped.size(); ++i) {
    if (difference.valid[i] != 0)
      clipped[i] =
          std::clamp(difference.change[i] / noise.at(difference, i), -most_deviations, most_deviations);
  }
  const auto window_sum = [](const cv::Mat& of) {
    cv::Mat sum;
    cv::boxFilter(of, sum, CV_32F, {window_px, window_px}, {-1, -1}, false);
    return sum;
  };
  PairEvidence evidence{window_sum(as_mat(clipped)), window_sum(as_mat(difference.change)),
                        window_sum(as_weights(as_mat(difference.valid)))};
  const cv::Mat some = cv::max(evidence.pixels, 1.0);
  cv::Mat root;
  cv::sqrt(some, root);
  evidence.deviations /= root;
  evidence.contrast /= some;
  return evidence;
}

float median_of(std::span<float> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5F * (values[middle - 1] + values[middle]);
}

/// The values of all pairs at one pixel.
struct PixelValues {
  std::vector<float> deviations;
  std::vector<float> contrasts;

  void collect(const std::vector<PairEvidence>& pairs, int u, int v) {
    constexpr float least_pixels = 10.0F;  // of the window
    deviations.clear();
    contrasts.clear();
    for (const PairEvidence& pair : pairs) {
      if (pair.pixels.at<float>(v, u) < least_pixels) continue;
      deviations.push_back(pair.deviations.at<float>(v, u));
      contrasts.push_back(pair.contrast.at<float>(v, u));
    }
  }
};

// Takes the median over the pairs at pixels seen by at least half of the pairs and at least `fewest`.
// Equation 61 of docs/math.md.
PairedChange median_over(const std::vector<PairEvidence>& pairs, std::size_t fewest, const Mask& lit) {
  PairedChange change{Image<float>(lit.width(), lit.height()), Image<float>(lit.width(), lit.height()),
                      Mask(lit.width(), lit.height())};
  const std::size_t least = std::max(fewest, pairs.size() / 2);
  const auto judge_row = [&](int v, PixelValues& values) {
    for (int u = 0; u < lit.width(); ++u) {
      if (lit(u, v) == 0) continue;
      values.collect(pairs, u, v);
      if (values.deviations.size() < least) continue;
      change.judged(u, v) = mask_set;
      change.deviations(u, v) = median_of(values.deviations);
      change.contrast(u, v) = median_of(values.contrasts);
    }
  };
  parallel_bands(lit.height(), [&](int first, int end) {
    PixelValues values;
    for (int v = first; v < end; ++v) judge_row(v, values);
  });
  return change;
}

// Normalises deviations by those of the unchanged majority, since noise of neighbouring pixels is correlated,
// and a median scatters less than its values.
// Equation 61 of docs/math.md.
void divide_by_bulk(PairedChange& change) {
  const float deviation = deviation_of(as_mat(change.deviations), change.judged);
  if (deviation <= 0.0F) return;
  for (float& value : change.deviations.pixels()) value /= deviation;
}

template <typename Result>
std::vector<Result> each(std::size_t count, const auto& work) {
  std::vector<Result> results(count);
  parallel_bands(static_cast<int>(count), [&](int first, int end) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k)
      results[k] = work(k);
  });
  return results;
}

}  // namespace

PairedChange paired_change(const ReferenceSurface& surface, const std::vector<InfraredView>& initial,
                           const std::vector<InfraredView>& final, const DotFreeImage& texture,
                           const Mask& lit) {
  const std::vector<Pair> pairs = pairs_of(initial, final);
  if (pairs.size() < least_pairs)
    return {Image<float>(lit.width(), lit.height()), Image<float>(lit.width(), lit.height()),
            Mask(lit.width(), lit.height())};
  const Image<float> filled = without_gaps(texture);
  const auto differences = each<PairDifference>(pairs.size(), [&](std::size_t k) {
    return pair_difference(*pairs[k].initial, *pairs[k].final, surface, filled);
  });
  const PixelNoise noise(differences);
  const auto evidence =
      each<PairEvidence>(pairs.size(), [&](std::size_t k) { return evidence_of(differences[k], noise); });
  PairedChange change = median_over(evidence, least_pairs, lit);
  divide_by_bulk(change);
  return change;
}

namespace {

// Least mean brightness, in grey levels: in a hole into which no dot falls, most pixels are 0, and the few
// others would seem significant.
constexpr float least_light = 2.0F;

// The mean over 15 x 15 pixels, in grey levels scaled as in InfraredView.
cv::Mat light_around(const InfraredView& view) {
  constexpr double floor_grey = 3.0;  // of log_grey()
  constexpr int around_px = 15;
  cv::Mat grey;
  cv::exp(as_mat(view.log_image), grey);
  cv::Mat around;
  cv::blur(grey, around, {around_px, around_px});
  return around - floor_grey;
}

}  // namespace

PairedChange still_change(const ReferenceSurface& surface, const InfraredView& initial,
                          const InfraredView& final, const Mask& lit) {
  constexpr int margin_px = 6;  // within it, windows lie entirely in the image
  const int width = surface.camera.width;
  const int height = surface.camera.height;
  const PairDifference difference = pair_difference(initial, final, surface, Image<float>(width, height));
  Mask inside(width, height);
  for (int v = margin_px; v < height - margin_px; ++v) {
    for (int u = margin_px; u < width - margin_px; ++u) inside(u, v) = lit(u, v);
  }
  PairedChange change = median_over({evidence_of(difference, PixelNoise({difference}))}, 1, inside);
  divide_by_bulk(change);
  return change;
}

PairedChange still_change(const ReferenceSurface& surface, const InfraredView& initial,
                          const InfraredView& final) {
  const Mask dark_before = beyond_projector(initial.log_image, initial.dots, beside_field_px);
  const Mask dark_after = beyond_projector(final.log_image, final.dots, beside_field_px);
  Mask lit(dark_before.width(), dark_before.height());
  const cv::Mat light = cv::min(light_around(initial), light_around(final));
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (dark_before[i] == 0 && dark_after[i] == 0 && light.ptr<float>()[i] >= least_light) lit[i] = mask_set;
  }
  return still_change(surface, initial, final, lit);
}

}  // namespace rva
