#include "detect/spatial/surface_support.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/interrupt.hpp"
#include "core/parallel.hpp"
#include "core/quantile.hpp"
#include "depth/mat_view.hpp"
#include "detect/regions/regions.hpp"
#include "infrared/dot_mask.hpp"
#include "stereo/surface_objection.hpp"

namespace rva {
namespace {

// Thresholds of the mean objection over a blob, in variances: between those of false changes and those of
// debris in development (docs/infrared.md).
constexpr double least_variances = 12.0;
constexpr double least_variances_nearby = 6.0;
constexpr std::size_t least_interior_px = 5;
constexpr std::size_t least_views_of_an_edge = 4;

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

// Surface of one side in the final view. Pixels without depth on this side count as unchanged.
ReferenceSurface surface_of(const Image<float>& depth_m, const Image<float>& otherwise_m,
                            const DepthView& view) {
  Image<float> disparity_px(depth_m.width(), depth_m.height());
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    const float here_m = depth_m[i] > 0.0F ? depth_m[i] : otherwise_m[i];
    if (here_m > 0.0F) disparity_px[i] = static_cast<float>(view.stereo.focal_baseline_m_px) / here_m;
  }
  return reference_surface(view.camera, disparity_px, view.stereo);
}

bool is_measured(const Comparison& comparison, std::size_t i) {
  return comparison.initial_m[i] > 0.0F && comparison.final_m[i] > 0.0F;
}

// Pixels that no pair sees count with an objection of 0.
double mean_over(const std::vector<std::uint32_t>& pixels, const Image<float>& variances) {
  double sum = 0.0;
  for (const std::uint32_t i : pixels) sum += static_cast<double>(variances[i]);
  return sum / static_cast<double>(pixels.size());
}

// Set at pixels where the shape, centred there, lies entirely on the blob.
Mask eroded(const std::vector<std::uint32_t>& pixels, int width, int height, const cv::Mat& shape) {
  Mask blob(width, height);
  for (const std::uint32_t i : pixels) blob[i] = mask_set;
  cv::Mat mask = as_mat(blob);
  cv::erode(mask, mask, shape);
  return blob;
}

// The pixels of a blob whose neighbourhood of 5 x 5 pixels lies on it.
std::vector<std::uint32_t> interior_of(const std::vector<std::uint32_t>& pixels, int width, int height) {
  const Mask inner = eroded(pixels, width, height, cv::Mat::ones(5, 5, CV_8U));
  std::vector<std::uint32_t> interior;
  std::ranges::copy_if(pixels, std::back_inserter(interior), [&](std::uint32_t i) { return inner[i] != 0; });
  return interior;
}

// True if a blob is too thick to be a misplaced edge. Either matcher may misplace an edge by four pixels,
// half of its window. Two of them are tolerated in either view (free_space.cpp), which leaves lines of up to
// four pixels where nothing changed. Windows of five pixels on such a line include the surfaces on both sides
// of it.
bool is_thicker_than_an_edge(const std::vector<std::uint32_t>& pixels, int width, int height) {
  constexpr int thicker_px = 5;
  cv::Mat disc = cv::Mat::ones(thicker_px, thicker_px, CV_8U);
  for (const int row : {0, thicker_px - 1}) {
    for (const int column : {0, thicker_px - 1}) disc.at<std::uint8_t>(row, column) = 0;
  }
  return std::ranges::count(eroded(pixels, width, height, disc).pixels(), mask_set) > 0;
}

// True if a blob is a wrong match near the camera: a few pixels that are smaller there than any debris, and
// lie far in front of or behind their surroundings.
bool is_spike(const std::vector<std::uint32_t>& pixels, const Comparison& comparison, double focal_px) {
  constexpr float least_width_m = 0.002F;
  constexpr float most_height_per_width = 20.0F;
  std::vector<float> heights_m;
  std::vector<float> nearest_m;
  for (const std::uint32_t i : pixels) {
    heights_m.push_back(std::abs(comparison.initial_m[i] - comparison.final_m[i]));
    nearest_m.push_back(std::min(comparison.initial_m[i], comparison.final_m[i]));
  }
  const float width_px = std::sqrt(static_cast<float>(pixels.size()));
  const float width_m = width_px * quantile(nearest_m, 0.5) / static_cast<float>(focal_px);
  return width_m < least_width_m && quantile(heights_m, 0.5) > most_height_per_width * width_m;
}

enum class Support { none, some, unknown };

// Decides whether the pairs support a blob. Registration is not exact to the last pixel, and both sides
// object to an edge that is a pixel off. A blob with an interior is therefore judged by its interior, and one
// without by the least objection within a pixel.
Support support_of(const Region& blob, const SurfaceObjection& objection, const Comparison& comparison,
                   double focal_px, bool edges_may_be_off) {
  std::vector<std::uint32_t> measured;
  std::ranges::copy_if(blob.pixels, std::back_inserter(measured),
                       [&](std::uint32_t i) { return is_measured(comparison, i); });
  if (5 * measured.size() < blob.pixels.size()) return Support::unknown;
  if (is_spike(measured, comparison, focal_px)) return Support::none;
  const int width = comparison.changed.width();
  const int height = comparison.changed.height();
  if (edges_may_be_off && !is_thicker_than_an_edge(measured, width, height)) return Support::none;
  const std::vector<std::uint32_t> interior = interior_of(measured, width, height);
  const bool supported = interior.size() >= least_interior_px
                             ? mean_over(interior, objection.variances) >= least_variances
                             : mean_over(measured, objection.variances_nearby) >= least_variances_nearby;
  return supported ? Support::some : Support::none;
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

double rarity_of_support(std::size_t captures, const Transform& initial_from_final) {
  return captures < least_views_of_an_edge && came_back_nearly(initial_from_final) ? 1.0 : 20.0;
}

void keep_supported(const Captures& initial, const Captures& final, const PlacedCaptures& placed,
                    const Transform& initial_from_final, double false_findings, Comparison& comparison) {
  if (cv::countNonZero(as_mat(comparison.changed)) == 0) return;
  const DepthView& view = placed.final_view;
  std::vector<StereoView> before = pairs_of(initial, placed.first_from_initial, initial_from_final);
  std::vector<StereoView> after = pairs_of(final, placed.first_from_final, Transform::Identity());
  const SurfaceObjection objection = surface_objection(
      surface_of(comparison.initial_m, comparison.final_m, view),
      surface_of(comparison.final_m, comparison.initial_m, view), view.stereo, before, after);
  const auto shown_by_depth = static_cast<float>(-std::log10(false_findings));
  const std::size_t captures = std::min(initial.size(), final.size());
  const auto rarer = static_cast<float>(std::log10(rarity_of_support(captures, initial_from_final)));
  // With several views, the mean has its edges in the right position. For a camera that returned nearly,
  // depth proposes no more than is allowed, and a key may be no thicker than a line.
  const bool edges_may_be_off = captures < least_views_of_an_edge && !came_back_nearly(initial_from_final);
  for (const Region& blob : find_regions(comparison.changed, {.min_blob_px = 0, .join_px = 0.0})) {
    const Support support = support_of(blob, objection, comparison, view.camera.fx, edges_may_be_off);
    if (support == Support::some) {
      for (const std::uint32_t i : blob.pixels) comparison.evidence[i] += rarer;
    } else if (support == Support::none || rarest(blob, comparison) < shown_by_depth) {
      take_back(blob, comparison);
    }
  }
}

}  // namespace rva
