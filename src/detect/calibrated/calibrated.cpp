#include "detect/calibrated/calibrated.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "depth/mat_view.hpp"
#include "detect/blobs.hpp"
#include "detect/calibrated/disparity_change.hpp"
#include "detect/calibrated/drift.hpp"
#include "detect/calibrated/false_alarm_tail.hpp"
#include "detect/calibrated/noise_by_place.hpp"
#include "detect/calibrated/pooled_evidence.hpp"

namespace rva {
namespace {

// The matcher's own window, in which a collar shows at best; a tool; a rag.
constexpr std::array<int, 3> windows_px{9, 15, 31};
constexpr double looks = 2.0 * windows_px.size();  // nearer and farther, at each scale
// Between an exponential tail (1) and a normal one (2), nearer to the former: places where the matcher is
// unsure differ from capture to capture more often than a normal distribution knows. Without repeated frames,
// wrong matches cannot be told from noise, and the tail is taken to be as heavy as an exponential one.
constexpr double shape_of_means = 1.2;
constexpr double shape_of_single_frames = 1.0;
constexpr float common = -1000.0F;  // less rare than anything

Image<float> evidence_of(const DisparityChange& change, const Image<float>& drift_px,
                         const Image<float>& deviation_px) {
  Image<float> evidence(change.judged.width(), change.judged.height());
  constexpr auto most = static_cast<float>(most_deviations);
  constexpr float least_px = 1e-6F;  // no division by zero where nothing was judged
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const float deviations = (change.change_px(i) - drift_px[i]) / std::max(deviation_px[i], least_px);
    evidence[i] = deviation_px[i] > 0.0F ? std::min(std::max(deviations, -most), most) : 0.0F;
  }
  return evidence;
}

// The greatest evidence of each block of twice the window, nearer and farther.
std::vector<float> peaks_of(const PooledEvidence& pooled) {
  const int block_px = 2 * pooled.window_px;
  const int columns = (pooled.pooled.width() + block_px - 1) / block_px;
  const int rows = (pooled.pooled.height() + block_px - 1) / block_px;
  Image<float> nearer(columns, rows);
  Image<float> farther(columns, rows);
  for (int v = 0; v < pooled.pooled.height(); ++v) {
    for (int column = 0; column < columns; ++column) {
      const int end = std::min((column + 1) * block_px, pooled.pooled.width());
      float& most_near = nearer(column, v / block_px);
      float& most_far = farther(column, v / block_px);
      for (int u = column * block_px; u < end; ++u) {
        most_near = std::max(most_near, pooled.deviations(u, v));
        most_far = std::max(most_far, -pooled.deviations(u, v));
      }
    }
  }
  std::vector<float> peaks(nearer.pixels().begin(), nearer.pixels().end());
  peaks.insert(peaks.end(), farther.pixels().begin(), farther.pixels().end());
  return peaks;
}

struct Scale {
  DetectionScale detection;
  FalseAlarmTail tail;
};

Scale look_at(const Image<float>& evidence, const Mask& judged, int window_px, double false_findings,
              double shape) {
  PooledEvidence pooled = pool(evidence, judged, window_px);
  const FalseAlarmTail tail = fit_tail(peaks_of(pooled), shape);
  return {{std::move(pooled), tail.height_of(false_findings / looks)}, tail};
}

/// What one scale saw of one sign.
struct Sighting {
  Mask around;          ///< within half a window of where the threshold is exceeded
  Image<float> rarity;  ///< there: -log10 of the expected false findings as strong
};

std::optional<Sighting> sighting(const Scale& scale, float sign) {
  const PooledEvidence& evidence = scale.detection.evidence;
  Sighting seen{Mask(evidence.pooled.width(), evidence.pooled.height()),
                Image<float>(evidence.pooled.width(), evidence.pooled.height(), common)};
  cv::Rect where;
  for (int v = 0; v < seen.around.height(); ++v) {
    for (int u = 0; u < seen.around.width(); ++u) {
      const double deviations = static_cast<double>(sign * evidence.deviations(u, v));
      if (deviations <= scale.detection.threshold) continue;
      where |= cv::Rect(u, v, 1, 1);
      seen.around(u, v) = mask_set;
      seen.rarity(u, v) =
          static_cast<float>(-std::log10(looks) - scale.tail.log10_expected_above(deviations));
    }
  }
  if (where.empty()) return std::nullopt;
  const int half = evidence.window_px / 2;
  where = cv::Rect(where.x - half, where.y - half, where.width + 2 * half, where.height + 2 * half) &
          cv::Rect(0, 0, seen.around.width(), seen.around.height());
  const cv::Mat window = cv::Mat::ones(evidence.window_px, evidence.window_px, CV_8U);
  cv::Mat around = as_mat(seen.around)(where);
  cv::Mat rarity = as_mat(seen.rarity)(where);
  cv::dilate(around, around, window);
  cv::dilate(rarity, rarity, window);
  return seen;
}

/// Marks what the scales saw, from fine to coarse: a change has its outline from the finest scale that saw
/// it, coarser ones only make it rarer.
class Outlines {
 public:
  Outlines(const Image<float>& evidence, Comparison& comparison)
      : evidence_(evidence),
        comparison_(comparison),
        outlined_{Mask(evidence.width(), evidence.height()), Mask(evidence.width(), evidence.height())} {}

  void add(const Scale& scale, float sign) {
    const std::optional<Sighting> seen = sighting(scale, sign);
    if (!seen) return;
    Mask& outlined = outlined_[sign > 0.0F ? 0 : 1];
    const Blobs blobs(seen->around);
    std::vector<std::uint8_t> known(blobs.count(), 0);
    std::vector<float> peaks(blobs.count(), 0.0F);
    const PooledEvidence& pooled = scale.detection.evidence;
    for_each_pixel(blobs, [&](std::size_t i, std::size_t blob) {
      known[blob] |= outlined[i];
      peaks[blob] = std::max(peaks[blob], sign * pooled.deviations[i]);
    });
    // At least half of the mean evidence of the window that shows most.
    const auto half = static_cast<float>(0.5 * pooled.agreement / pooled.window_px);
    for_each_pixel(blobs, [&](std::size_t i, std::size_t blob) {
      if (comparison_.changed[i] != 0) {
        comparison_.evidence[i] = std::max(comparison_.evidence[i], seen->rarity[i]);
      } else if (known[blob] == 0 && sign * evidence_[i] > half * peaks[blob]) {
        comparison_.changed[i] = mask_set;
        comparison_.evidence[i] = seen->rarity[i];
      }
    });
    for (std::size_t i = 0; i < outlined.size(); ++i) outlined[i] |= seen->around[i];
  }

 private:
  template <typename Work>
  void for_each_pixel(const Blobs& blobs, Work work) const {
    for (const Run& run : blobs.runs()) {
      for (int u = run.first; u < run.end; ++u)
        work(static_cast<std::size_t>(&evidence_(u, run.v) - evidence_.data()), run.blob);
    }
  }

  const Image<float>& evidence_;
  Comparison& comparison_;
  std::array<Mask, 2> outlined_;
};

// The depth before is what the camera would have measured had it been as warm as after: heights are of
// things, not of drift.
void fill_depth(const DisparityChange& change, const Image<float>& drift_px, double disparity_m_px,
                Comparison& comparison) {
  const auto product = static_cast<float>(disparity_m_px);
  for (std::size_t i = 0; i < drift_px.size(); ++i) {
    if (change.before_px[i] > 0.0F) comparison.initial_m[i] = product / (change.before_px[i] + drift_px[i]);
    if (change.after_px[i] > 0.0F) comparison.final_m[i] = product / change.after_px[i];
  }
}

double share(std::size_t pixels, const Mask& of) {
  return static_cast<double>(pixels) / static_cast<double>(of.size());
}

Coverage coverage_of(const DisparityChange& change) {
  std::size_t compared = 0;
  std::size_t unseen = 0;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (change.after_px[i] <= 0.0F) continue;
    ++(change.before_px[i] > 0.0F ? compared : unseen);
  }
  return {share(compared, change.judged), share(unseen, change.judged),
          share(change.judged.size() - compared - unseen, change.judged), std::nullopt};
}

// Share of the compared pixels that could not be judged. The margin is another matter: it is the same in
// every view; and what is far is told by its level of detection.
double blind_share(const DisparityChange& change, const Image<float>& level_mm) {
  std::size_t compared = 0;
  std::size_t blind = 0;
  for (int v = margin_px; v < level_mm.height() - margin_px; ++v) {
    for (int u = margin_px; u < level_mm.width() - margin_px; ++u) {
      const bool both = change.after_px(u, v) > 0.0F && change.before_px(u, v) > 0.0F;
      compared += both ? 1 : 0;
      blind += both && std::isnan(level_mm(u, v)) ? 1 : 0;
    }
  }
  return static_cast<double>(blind) / static_cast<double>(std::max<std::size_t>(compared, 1));
}

}  // namespace

CalibratedComparison compare_calibrated(const DepthStatistics& initial, const DepthStatistics& final,
                                        double unit_m, double disparity_m_px,
                                        const CalibratedOptions& options) {
  const double disparity_by_depth = disparity_m_px / unit_m;
  const DisparityChange change = disparity_change(initial, final, disparity_by_depth);
  const Drift drift = fit_drift(change);
  const Image<float> drift_px = drift.px();
  const NoiseByPlace noise = noise_by_place(change, drift_px, drift.variance_px2(), disparity_by_depth);
  const Image<float> evidence = evidence_of(change, drift_px, noise.deviation_px);
  const bool single = std::min(initial.frames(), final.frames()) < 2;

  CalibratedComparison result{Comparison(final.width(), final.height()), {}, {}};
  Comparison& comparison = result.comparison;
  comparison.evidence_is_rarity = true;
  fill_depth(change, drift_px, disparity_m_px, comparison);
  Outlines outlines(evidence, comparison);
  std::vector<DetectionScale> scales;
  for (const int window_px : windows_px) {
    Scale scale = look_at(evidence, change.judged, window_px, options.false_findings,
                          single ? shape_of_single_frames : shape_of_means);
    for (const float sign : {1.0F, -1.0F}) outlines.add(scale, sign);
    scales.push_back(std::move(scale.detection));
  }
  const DetectionScale& finest = finest_reachable(scales);
  result.level_of_detection_mm =
      level_of_detection_mm(noise.deviation_px, comparison.final_m, finest, disparity_m_px);
  const auto judged = static_cast<std::size_t>(std::ranges::count_if(
      result.level_of_detection_mm.pixels(), [](float level) { return !std::isnan(level); }));
  result.levels = {share(judged, change.judged),
                   finest.evidence.window_px,
                   static_cast<double>(drift_px(final.width() / 2, final.height() / 2)),
                   noise.fixed_px,
                   noise.effective_frames,
                   levels_by_distance(result.level_of_detection_mm, comparison.final_m)};
  comparison.coverage = coverage_of(change);
  comparison.blind = blind_share(change, result.level_of_detection_mm);
  return result;
}

}  // namespace rva
