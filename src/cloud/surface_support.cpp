#include "cloud/surface_support.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/interrupt.hpp"
#include "core/parallel.hpp"
#include "depth/mat_view.hpp"
#include "detect/regions.hpp"
#include "infrared/dot_mask.hpp"
#include "stereo/surface_objection.hpp"

namespace rva {
namespace {

// Mean over a blob of the variances by which the pairs object: between what false changes had in development
// and what debris had (docs/infrared.md).
constexpr double least_variances = 6.0;
constexpr std::size_t least_pairs = 4;

std::vector<StereoView> pairs_of(const Captures& side, const std::vector<Transform>& first_from_view,
                                 const Transform& first_from_reference) {
  std::vector<StereoView> pairs(side.size());
  parallel_bands(static_cast<int>(side.size()), [&](int first, int end) {
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k) {
      throw_if_interrupted();
      pairs[k].left = log_grey(side[k]->infrared_mean(Imager::left, Light::projector).value());
      pairs[k].right = log_grey(side[k]->infrared_mean(Imager::right, Light::projector).value());
      pairs[k].view_from_reference = first_from_view[k].inverse() * first_from_reference;
    }
  });
  return pairs;
}

// In the final view. What was not seen before counts as unchanged.
ReferenceSurface surface_of(const Image<float>& depth_m, const Image<float>& otherwise_m,
                            const DepthView& view) {
  Image<float> disparity_px(depth_m.width(), depth_m.height());
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    const float here_m = depth_m[i] > 0.0F ? depth_m[i] : otherwise_m[i];
    if (here_m > 0.0F) disparity_px[i] = static_cast<float>(view.disparity_m_px) / here_m;
  }
  return reference_surface(view.camera, disparity_px, view.disparity_m_px);
}

/// Where no pair sees what depth claims to have measured, nothing objects. Empty where less than a fifth of
/// the blob has depth on both sides.
std::optional<double> mean_variances(const Region& blob, const SurfaceObjection& objection,
                                     const Comparison& comparison) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const std::uint32_t i : blob.pixels) {
    const bool measured = comparison.initial_m[i] > 0.0F && comparison.final_m[i] > 0.0F;
    if (!measured) continue;
    sum += static_cast<double>(objection.variances[i]);
    ++count;
  }
  if (5 * count < blob.pixels.size()) return std::nullopt;
  return sum / static_cast<double>(count);
}

float rarest(const Region& blob, const Comparison& comparison) {
  float most = 0.0F;
  for (const std::uint32_t i : blob.pixels) most = std::max(most, comparison.evidence[i]);
  return most;
}

void take_back(const Region& blob, Comparison& comparison) {
  for (const std::uint32_t i : blob.pixels) {
    comparison.changed[i] = comparison.farther[i] = 0;
    comparison.evidence[i] = 0.0F;
  }
}

}  // namespace

bool have_pairs(const Captures& initial, const Captures& final) {
  const auto have = [](const Captures& side) {
    return std::ranges::all_of(side, [](const auto& capture) {
      return capture->has_infrared(Imager::left, Light::projector) &&
             capture->has_infrared(Imager::right, Light::projector);
    });
  };
  return have(initial) && have(final);
}

double rarity_of_support(const Captures& initial, const Captures& final) {
  return std::min(initial.size(), final.size()) >= least_pairs ? 20.0 : 1.0;
}

void keep_supported(const Captures& initial, const Captures& final, const PlacedCaptures& placed,
                    const Transform& initial_from_final, double false_findings, Comparison& comparison) {
  if (cv::countNonZero(as_mat(comparison.changed)) == 0) return;
  const DepthView& view = placed.final_view;
  std::vector<StereoView> before = pairs_of(initial, placed.first_from_initial, initial_from_final);
  std::vector<StereoView> after = pairs_of(final, placed.first_from_final, Transform::Identity());
  const SurfaceObjection objection = surface_objection(
      surface_of(comparison.initial_m, comparison.final_m, view),
      surface_of(comparison.final_m, comparison.initial_m, view), view.disparity_m_px, before, after);
  const auto shown_by_depth = static_cast<float>(-std::log10(false_findings));
  const auto support = static_cast<float>(std::log10(rarity_of_support(initial, final)));
  for (const Region& blob : find_regions(comparison.changed, {.min_blob_px = 0, .join_px = 0.0})) {
    const std::optional<double> variances = mean_variances(blob, objection, comparison);
    if (variances && *variances >= least_variances) {
      for (const std::uint32_t i : blob.pixels) comparison.evidence[i] += support;
    } else if (variances || rarest(blob, comparison) < shown_by_depth) {
      take_back(blob, comparison);
    }
  }
}

}  // namespace rva
