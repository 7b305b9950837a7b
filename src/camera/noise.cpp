#include "camera/noise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "capture/frame_reader.hpp"
#include "capture/frozen.hpp"
#include "core/error.hpp"
#include "core/quantile.hpp"
#include "core/units.hpp"

namespace rva {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// Unbiased variance of the mean: s^2 / n. scaled_variance() is n^2 times the population variance.
double variance_of_mean(const DepthStatistics& statistics, std::size_t i) {
  const double n = statistics.count(i);
  return static_cast<double>(statistics.scaled_variance(i)) / (n * n * (n - 1.0));
}

// The deviations of the pixels in one range of distances.
struct Sample {
  std::vector<float> std_mm;
  double sum_of_squared_disparity_std = 0.0;

  void add(float value_mm, double disparity_std_px) {
    std_mm.push_back(value_mm);
    sum_of_squared_disparity_std += disparity_std_px * disparity_std_px;
  }

  [[nodiscard]] NoiseBin figures(double from_m, double to_m, bool stereo) {
    NoiseBin bin{.from_m = from_m, .to_m = to_m, .pixels = std_mm.size(), .subpixel_rms_px = {}};
    if (std_mm.empty()) return bin;
    bin.median_std_mm = quantile(std_mm, 0.5);
    bin.p95_std_mm = quantile(std_mm, 0.95);
    if (stereo)
      bin.subpixel_rms_px = std::sqrt(sum_of_squared_disparity_std / static_cast<double>(std_mm.size()));
    return bin;
  }
};

// Equation 2 of docs/math.md.
void measure_deviation(const DepthStatistics& all, const CaptureInfo& info, double bin_m, Noise& noise) {
  const std::optional<double> baseline_m = info.camera ? info.camera->baseline_m : std::nullopt;
  Sample overall;
  std::map<int, Sample> bins;
  double nearest_m = std::numeric_limits<double>::infinity();
  double farthest_m = 0.0;
  std::size_t measurements = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    measurements += all.count(i);
    if (all.count(i) < 2) continue;
    const double z_m = all.mean(i) * info.depth_unit_m;
    const double std_m = all.standard_deviation(i) * info.depth_unit_m;
    // dz = z^2 / (f B) dd: the deviation of depth, converted to disparity.
    const double disparity_std_px = baseline_m ? std_m * info.depth.fx * *baseline_m / (z_m * z_m) : 0.0;
    const auto std_mm = static_cast<float>(std_m * mm_per_m);
    noise.std_mm[i] = std_mm;
    nearest_m = std::min(nearest_m, z_m);
    farthest_m = std::max(farthest_m, z_m);
    overall.add(std_mm, disparity_std_px);
    bins[static_cast<int>(z_m / bin_m)].add(std_mm, disparity_std_px);
  }
  NoiseReport& report = noise.report;
  report.fill_rate = static_cast<double>(measurements) / static_cast<double>(all.size() * all.frames());
  report.overall =
      overall.figures(overall.std_mm.empty() ? 0.0 : nearest_m, farthest_m, baseline_m.has_value());
  for (auto& [index, sample] : bins) {
    report.bins.push_back(sample.figures(index * bin_m, (index + 1) * bin_m, baseline_m.has_value()));
  }
}

void measure_drift(const DepthStatistics& first, const DepthStatistics& last, Noise& noise) {
  NoiseReport& report = noise.report;
  std::size_t rejected = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double p = welch_p_value(first, last, i);
    noise.welch_p[i] = static_cast<float>(p);
    if (std::isnan(p)) continue;
    report.welch_tested_px += 1;
    if (p < report.alpha) rejected += 1;
  }
  if (report.welch_tested_px > 0) {
    report.welch_rejected = static_cast<double>(rejected) / static_cast<double>(report.welch_tested_px);
  }
}

}  // namespace

double welch_p_value(const DepthStatistics& a, const DepthStatistics& b, std::size_t i) {
  const double n_a = a.count(i);
  const double n_b = b.count(i);
  if (n_a < 2 || n_b < 2) return std::numeric_limits<double>::quiet_NaN();
  const double difference = a.mean(i) - b.mean(i);
  const double variance_a = variance_of_mean(a, i);
  const double variance_b = variance_of_mean(b, i);
  const double variance = variance_a + variance_b;
  if (variance == 0.0) return difference == 0.0 ? 1.0 : 0.0;
  const double t = difference / std::sqrt(variance);
  const double degrees_of_freedom =
      variance * variance / (variance_a * variance_a / (n_a - 1.0) + variance_b * variance_b / (n_b - 1.0));
  const boost::math::students_t distribution(degrees_of_freedom);
  return 2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(t)));
}

Noise measure_noise(const Capture& capture, const NoiseOptions& options, const Progress& progress) {
  check_options(options);
  const std::size_t available = capture.depth_frames();
  const std::size_t frames =
      options.frames == 0 ? available : std::min(available, static_cast<std::size_t>(options.frames));
  if (frames < 4) {
    throw Error("noise", fmt::format("{} frame(s), but at least four are needed", frames),
                "record or use more frames; 100 give a good estimate");
  }
  if (is_frozen(capture, frames)) throw frozen_camera("noise");
  const std::size_t welch_frames = std::min(static_cast<std::size_t>(options.welch_frames), frames / 2);
  const Intrinsics& camera = capture.info().depth;
  DepthStatistics all(camera.width, camera.height);
  DepthStatistics first(camera.width, camera.height);
  DepthStatistics last(camera.width, camera.height);
  for_each_depth_frame(capture, frames, progress, [&](const DepthImage& frame) {
    const std::size_t index = all.frames();
    all.add(frame);
    if (index < welch_frames) first.add(frame);
    if (index >= frames - welch_frames) last.add(frame);
  });
  Noise noise{Image<float>(camera.width, camera.height, not_a_number),
              Image<float>(camera.width, camera.height, not_a_number),
              {}};
  noise.report.frames = frames;
  noise.report.welch_frames = welch_frames;
  noise.report.alpha = options.alpha;
  measure_deviation(all, capture.info(), options.bin_m, noise);
  measure_drift(first, last, noise);
  return noise;
}

}  // namespace rva
