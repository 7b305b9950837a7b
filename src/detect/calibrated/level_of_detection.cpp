#include "detect/calibrated/level_of_detection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "core/quantile.hpp"
#include "core/units.hpp"
#include "depth/colorize.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
constexpr double class_m = 0.2;
constexpr std::size_t sampling = 3;  // neighbouring pixels are similar

// The deviations that each pixel of the window must change by. The pooled evidence of w^2 pixels that all
// change by k deviations is k w, divided by `spread` for the correlation of neighbours.
// Equation 28 of docs/math.md.
double needed_deviations(const Scale& scale, double threshold) {
  return (threshold + nine_of_ten_deviations) * scale.evidence.spread / scale.evidence.window_px;
}

// The mean deviation of the judged pixels in a window around each pixel. Pixels that are not judged have the
// deviation 0.
Image<float> mean_of_judged(const Image<float>& deviation_px, int window_px) {
  const cv::Size window(window_px, window_px);
  const cv::Mat deviations = as_mat(deviation_px);
  cv::Mat judged;
  cv::Mat(deviations > 0.0F).convertTo(judged, CV_32F, 1.0 / mask_set);
  cv::Mat sum;
  cv::Mat share;
  cv::blur(deviations, sum, window);
  cv::blur(judged, share, window);
  Image<float> mean(deviation_px.width(), deviation_px.height());
  cv::Mat target = as_mat(mean);
  sum.copyTo(target);
  target /= cv::max(share, 1.0 / window.area());
  return mean;
}

}  // namespace

const Scale& finest_reachable(std::span<const Scale> scales) {
  const auto reachable = std::ranges::find_if(scales, [](const Scale& scale) {
    return needed_deviations(scale, scale.thresholds.reliable) <= most_deviations;
  });
  return reachable == scales.end() ? scales.back() : *reachable;
}

// Equation 29 of docs/math.md.
Image<float> level_of_detection_mm(const Mask& unreliable, const Image<float>& deviation_px,
                                   const Image<float>& depth_m, const Scale& scale,
                                   const StereoScale& stereo) {
  Image<float> level_mm(depth_m.width(), depth_m.height(), unknown);
  // No height can compensate for evidence that a pixel cannot provide, so the level is unknown there.
  const auto mm_per_px_at_1m = [&](double threshold) {
    const double deviations = needed_deviations(scale, threshold);
    return deviations > most_deviations
               ? unknown
               : static_cast<float>(mm_per_m * deviations / stereo.focal_baseline_m_px);
  };
  const float reliable_mm_per_px_at_1m = mm_per_px_at_1m(scale.thresholds.reliable);
  const float unreliable_mm_per_px_at_1m = mm_per_px_at_1m(scale.thresholds.unreliable);
  const Image<float> around_px = mean_of_judged(deviation_px, scale.evidence.window_px);
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    if (scale.evidence.pooled[i] == 0) continue;
    // An object is judged together with the pixels around it, which may be noisier.
    const float scaled = unreliable[i] != 0 ? unreliable_mm_per_px_at_1m : reliable_mm_per_px_at_1m;
    level_mm[i] = scaled * std::max(deviation_px[i], around_px[i]) * depth_m[i] * depth_m[i];
  }
  return level_mm;
}

double judged_share(const Image<float>& level_mm) {
  const auto judged =
      std::ranges::count_if(level_mm.pixels(), [](float level) { return !std::isnan(level); });
  return static_cast<double>(judged) / static_cast<double>(level_mm.size());
}

std::vector<DetectionLevels> levels_by_distance(const Image<float>& level_mm, const Image<float>& depth_m) {
  std::vector<std::vector<float>> classes;
  for (std::size_t i = 0; i < level_mm.size(); i += sampling) {
    if (std::isnan(level_mm[i])) continue;
    const auto k = static_cast<std::size_t>(static_cast<double>(depth_m[i]) / class_m);
    if (classes.size() <= k) classes.resize(k + 1);
    classes[k].push_back(level_mm[i]);
  }
  std::vector<DetectionLevels> levels;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    if (classes[k].empty()) continue;
    const double from_m = class_m * static_cast<double>(k);
    levels.push_back(
        {from_m, from_m + class_m, classes[k].size(), quantile(classes[k], 0.5), quantile(classes[k], 0.9)});
  }
  return levels;
}

Mask findable_mask(const Image<float>& level_mm, const Image<float>& depth_m, int window_px, double focal_px,
                   double size_mm) {
  const double farthest_m = size_mm * focal_px / (mm_per_m * window_px);
  Mask findable(level_mm.width(), level_mm.height());
  for (std::size_t i = 0; i < level_mm.size(); ++i) {
    if (level_mm[i] <= size_mm && depth_m[i] > 0.0F && depth_m[i] <= farthest_m) findable[i] = mask_set;
  }
  return findable;
}

double findable_share(const Image<float>& level_mm, const Image<float>& depth_m, int window_px,
                      double focal_px, double size_mm) {
  const Mask findable = findable_mask(level_mm, depth_m, window_px, focal_px, size_mm);
  return static_cast<double>(std::ranges::count(findable.pixels(), mask_set)) /
         static_cast<double>(findable.size());
}

std::vector<FindableShare> findable_shares(const Image<float>& level_mm, const Image<float>& depth_m,
                                           int window_px, double focal_px) {
  std::vector<FindableShare> shares;
  for (const double size_mm : findable_sizes_mm)
    shares.push_back({size_mm, findable_share(level_mm, depth_m, window_px, focal_px, size_mm)});
  return shares;
}

void state_widths(DetectionLevelSummary& summary, double focal_px) {
  for (DetectionLevels& levels : summary.by_distance)
    levels.width_mm = mm_per_m * summary.window_px * levels.to_m / focal_px;
}

nlohmann::ordered_json json_of(const DetectionLevelSummary& summary) {
  nlohmann::ordered_json json{{"format", "rva-level-of-detection"}, {"version", 1}};
  json["judged"] = summary.judged;
  json["window_px"] = summary.window_px;
  json["drift_px"] = summary.drift_px;
  json["fixed_px"] = summary.fixed_px;
  if (summary.effective_frames) json["effective_frames"] = *summary.effective_frames;
  json["by_distance"] = nlohmann::ordered_json::array();
  for (const DetectionLevels& levels : summary.by_distance) {
    json["by_distance"].push_back({{"from_m", levels.from_m},
                                   {"to_m", levels.to_m},
                                   {"pixels", levels.pixels},
                                   {"median_mm", levels.median_mm},
                                   {"p90_mm", levels.p90_mm}});
    if (levels.width_mm) json["by_distance"].back()["width_mm"] = *levels.width_mm;
  }
  if (!summary.findable.empty()) json["findable"] = nlohmann::ordered_json::array();
  for (const FindableShare& findable : summary.findable)
    json["findable"].push_back({{"size_mm", findable.size_mm}, {"share", findable.share}});
  return json;
}

ColorImage draw_level_of_detection(const Image<float>& level_mm) {
  const ColorScale scale = scale_from_zero(level_mm);
  return with_legend(colorize(level_mm, scale), scale, "least height\nfound (mm)");
}

}  // namespace rva
