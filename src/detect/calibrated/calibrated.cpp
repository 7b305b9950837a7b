#include "detect/calibrated/calibrated.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "detect/calibrated/noise_by_class.hpp"
#include "detect/calibrated/outlines.hpp"
#include "detect/calibrated/pooled_evidence.hpp"
#include "detect/calibrated/scale.hpp"
#include "detect/calibrated/unreliable_pixels.hpp"
#include "views/disparity_change.hpp"
#include "views/drift.hpp"

namespace rva {
namespace {

// Edges of the pooling windows: a little less than the matcher's own window, the most in which a collar
// shows; the size of a tool; the size of a rag.
constexpr std::array<int, 3> windows_px{7, 15, 31};
// Glass, bare metal and dark surfaces leave holes in depth, and so do the edges of small objects.
constexpr int lost_window_px = 9;
constexpr double lost_deviations = 30.0;  // evidence of a window that lost all of its depth
// Number of tails among which the allowed false findings are divided (Bonferroni): two signs times reliable
// and unreliable pixels, at each scale and for lost depth.
constexpr double tests = 4.0 * (windows_px.size() + 1);

// Equation 14 of docs/math.md.
Image<float> evidence_of(const DisparityChange& change, const Image<float>& drift_px,
                         const Image<float>& deviation_px) {
  Image<float> evidence(change.judged.width(), change.judged.height());
  constexpr auto most = static_cast<float>(most_deviations);
  constexpr float least_px = 1e-6F;  // avoids a division by zero where nothing was judged
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const float deviations = (change.change_px(i) - drift_px[i]) / std::max(deviation_px[i], least_px);
    evidence[i] = deviation_px[i] > 0.0F ? std::min(std::max(deviations, -most), most) : 0.0F;
  }
  return evidence;
}

// Equation 17 of docs/math.md.
PooledEvidence pool_lost(const Image<float>& lost) {
  const Mask everywhere(lost.width(), lost.height(), mask_set);
  return pool(lost, everywhere, lost_window_px, lost_window_px / lost_deviations);
}

/// A change with its drift, its noise and the evidence of each pixel that follows from them.
struct WeighedChange {
  WeighedChange(const DisparityChange& change, const StereoScale& stereo)
      : drift(fit_drift(change)),
        drift_px(drift.px()),
        unreliable(unreliable_pixels(change)),
        noise(noise_by_class(change, unreliable, drift_px, drift.variance_px2(), stereo)),
        evidence(evidence_of(change, drift_px, noise.deviation_px)) {}

  Drift drift;
  Image<float> drift_px;
  Mask unreliable;
  NoiseByClass noise;
  Image<float> evidence;
};

// Depth before is corrected for drift, as if the camera had been as warm as afterwards, so that heights are
// those of objects and not of drift.
void fill_depth(const DisparityChange& change, const Image<float>& drift_px, const StereoScale& stereo,
                Comparison& comparison) {
  const auto product = static_cast<float>(stereo.focal_baseline_m_px);
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
  std::size_t omitted = 0;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (is_left_out(change.left_out, i))
      ++omitted;
    else if (change.after_px[i] > 0.0F)
      ++(change.before_px[i] > 0.0F ? compared : unseen);
  }
  const std::size_t counted = compared + unseen + omitted;
  return {.compared = share(compared, change.judged),
          .unseen = share(unseen, change.judged),
          .invalid = share(change.judged.size() - counted, change.judged),
          .left_out = change.left_out.empty() ? std::nullopt : std::optional(share(omitted, change.judged))};
}

// Share of the compared pixels that could not be judged. The margin is excluded, as it is the same in
// every view. Pixels that are merely far away are not blind: their level of detection shows what could be
// found there.
double blind_share(const DisparityChange& change, const Image<float>& level_mm) {
  std::size_t compared = 0;
  std::size_t blind = 0;
  for (int v = margin_px; v < level_mm.height() - margin_px; ++v) {
    for (int u = margin_px; u < level_mm.width() - margin_px; ++u) {
      const bool omitted = !change.left_out.empty() && change.left_out(u, v) != 0;
      const bool both = !omitted && change.after_px(u, v) > 0.0F && change.before_px(u, v) > 0.0F;
      compared += both ? 1 : 0;
      blind += both && std::isnan(level_mm(u, v)) ? 1 : 0;
    }
  }
  return static_cast<double>(blind) / static_cast<double>(std::max<std::size_t>(compared, 1));
}

void clear_left_out(const Mask& left_out, CalibratedComparison& result) {
  for (std::size_t i = 0; i < left_out.size(); ++i) {
    if (left_out[i] == 0) continue;
    result.comparison.changed[i] = result.comparison.farther[i] = 0;
    result.comparison.evidence[i] = 0.0F;
    result.level_of_detection_mm[i] = std::numeric_limits<float>::quiet_NaN();
  }
}

}  // namespace

PriorSlopes prior_slopes(std::size_t frames) {
  return frames < 2 ? slopes_of_single_frames : slopes_of_means;
}

CalibratedPeaks peaks_of(const DisparityChange& change, const StereoScale& stereo) {
  const WeighedChange weighed(change, stereo);
  CalibratedPeaks peaks;
  for (const int window_px : windows_px) {
    const auto of_window = peaks_of(pool(weighed.evidence, change.judged, window_px), weighed.unreliable);
    peaks.change.reliable.insert(peaks.change.reliable.end(), of_window.reliable.begin(),
                                 of_window.reliable.end());
    peaks.change.unreliable.insert(peaks.change.unreliable.end(), of_window.unreliable.begin(),
                                   of_window.unreliable.end());
  }
  peaks.loss = peaks_of(pool_lost(change.lost), weighed.unreliable);
  return peaks;
}

CalibratedComparison compare_calibrated(const DepthStatistics& initial, const DepthStatistics& final,
                                        const StereoScale& stereo, const CalibratedOptions& options) {
  const DisparityChange change = disparity_change(initial, final, stereo);
  return compare_calibrated(change, stereo, prior_slopes(change.frames), options);
}

CalibratedComparison compare_calibrated(const DisparityChange& change, const StereoScale& stereo,
                                        const PriorSlopes& slopes, const CalibratedOptions& options) {
  const WeighedChange weighed(change, stereo);
  CalibratedComparison result{Comparison(change.judged.width(), change.judged.height()), {}, {}};
  Comparison& comparison = result.comparison;
  comparison.evidence_is_rarity = true;
  fill_depth(change, weighed.drift_px, stereo, comparison);
  const double false_findings = options.false_findings / tests;
  Outlines outlines(weighed.unreliable, tests, comparison);
  std::vector<Scale> scales;
  for (const int window_px : windows_px) {
    scales.push_back(scale_of(pool(weighed.evidence, change.judged, window_px), weighed.unreliable,
                              slopes.change, false_findings));
    outlines.add(scales.back(), weighed.evidence);
  }
  outlines.add(scale_of(pool_lost(change.lost), weighed.unreliable, slopes.loss, false_findings),
               change.lost);
  const Scale& finest = finest_reachable(scales);
  result.level_of_detection_mm = level_of_detection_mm(weighed.unreliable, weighed.noise.deviation_px,
                                                       comparison.final_m, finest, stereo);
  clear_left_out(change.left_out, result);
  result.levels = {.judged = judged_share(result.level_of_detection_mm),
                   .window_px = finest.evidence.window_px,
                   .drift_px = static_cast<double>(
                       weighed.drift_px(change.judged.width() / 2, change.judged.height() / 2)),
                   .fixed_px = weighed.noise.fixed_px,
                   .effective_frames = weighed.noise.effective_frames,
                   .by_distance = levels_by_distance(result.level_of_detection_mm, comparison.final_m)};
  comparison.coverage = coverage_of(change);
  comparison.blind = blind_share(change, result.level_of_detection_mm);
  return result;
}

}  // namespace rva
