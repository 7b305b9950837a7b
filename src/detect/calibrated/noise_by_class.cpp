#include "detect/calibrated/noise_by_class.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/quantile.hpp"

namespace rva {
namespace {

// A pixel may vary more than its class because it rarely changes level; as few as this many of its frames are
// then independent.
constexpr float independent_at_least = 4.0F;
// Boundaries of the classes, as quantiles of the deviation over time. Classes are narrower where noise is
// greatest, since it differs most there.
constexpr std::array<double, 6> class_shares{0.10, 0.30, 0.50, 0.70, 0.85, 0.95};
constexpr std::size_t class_count = 2 * (class_shares.size() + 1);  // each for reliable and unreliable pixels
constexpr std::size_t sampling = 11;  // neighbours are correlated, so a few pixels suffice
constexpr double lean_px = 50.0;      // weight of the whole image in every class, in sampled pixels

using Edges = std::array<float, class_shares.size()>;

Edges edges_of(const Image<float>& values, const Mask& judged) {
  std::vector<float> samples;
  for (std::size_t i = 0; i < values.size(); i += sampling) {
    if (judged[i] != 0) samples.push_back(values[i]);
  }
  Edges edges{};
  if (samples.empty()) return edges;
  std::ranges::transform(class_shares, edges.begin(), [&](double share) { return quantile(samples, share); });
  return edges;
}

int level_of(float value, const Edges& edges) {
  int level = 0;
  for (const float edge : edges) level += value > edge ? 1 : 0;
  return level;
}

Image<std::uint8_t> classes_of(const DisparityChange& change, const Mask& unreliable) {
  const Edges edges = edges_of(change.deviation_px, change.judged);
  Image<std::uint8_t> classes(change.judged.width(), change.judged.height());
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const int noise_class = 2 * level_of(change.deviation_px[i], edges) + (unreliable[i] != 0 ? 1 : 0);
    classes[i] = static_cast<std::uint8_t>(noise_class);
  }
  return classes;
}

/// One class of pixels.
struct NoiseClass {
  std::vector<float> sizes_px;  // absolute changes about the drift
  double time_variance_px2 = 0.0;
  double variance_px2 = 0.0;
};

// Fits variance = fixed^2 + deviation over time^2 / frames by least squares, with each class weighted by its
// number of pixels.
// Equation 10 of docs/math.md.
void explain(const std::vector<NoiseClass>& noise_classes, NoiseByClass& noise) {
  double n = 0.0;
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  for (const NoiseClass& noise_class : noise_classes) {
    const auto weight = static_cast<double>(noise_class.sizes_px.size());
    n += weight;
    x += weight * noise_class.time_variance_px2;
    y += weight * noise_class.variance_px2;
    xx += weight * noise_class.time_variance_px2 * noise_class.time_variance_px2;
    xy += weight * noise_class.time_variance_px2 * noise_class.variance_px2;
  }
  if (n <= 0.0) return;
  const double spread = xx - x * x / n;
  const double slope = spread > 0.0 ? (xy - x * y / n) / spread : 0.0;
  if (slope > 0.0) noise.effective_frames = 1.0 / slope;
  noise.fixed_px = std::sqrt(std::max(0.0, (y - std::max(slope, 0.0) * x) / n));
}

// Equation 8 of docs/math.md.
double variance_of(std::vector<float>& sizes_px) {
  if (sizes_px.empty()) return 0.0;
  const double deviation_px = static_cast<double>(robust_deviation(sizes_px));
  return deviation_px * deviation_px;
}

/// Fills the classes, and returns the absolute changes of all of them together.
std::vector<float> gather(const DisparityChange& change, const Image<float>& drift_px,
                          const Image<std::uint8_t>& classes, std::vector<NoiseClass>& noise_classes) {
  std::vector<float> all;
  for (std::size_t i = 0; i < change.judged.size(); i += sampling) {
    if (change.judged[i] == 0) continue;
    const float size_px = std::abs(change.change_px(i) - drift_px[i]);
    NoiseClass& noise_class = noise_classes[classes[i]];
    noise_class.sizes_px.push_back(size_px);
    noise_class.time_variance_px2 += static_cast<double>(change.deviation_px[i]) * change.deviation_px[i];
    all.push_back(size_px);
  }
  return all;
}

}  // namespace

// Equations 3, 8 and 9 of docs/math.md.
NoiseByClass noise_by_class(const DisparityChange& change, const Mask& unreliable,
                            const Image<float>& drift_px, const Image<float>& drift_variance_px2,
                            const StereoScale& stereo) {
  NoiseByClass noise{Image<float>(change.judged.width(), change.judged.height()), std::nullopt, 0.0};
  const Image<std::uint8_t> classes = classes_of(change, unreliable);
  std::vector<NoiseClass> noise_classes(class_count);
  std::vector<float> all = gather(change, drift_px, classes, noise_classes);
  const double whole_px2 = variance_of(all);
  std::array<float, class_count> variances_px2{};
  std::array<float, class_count> time_variances_px2{};
  for (std::size_t k = 0; k < variances_px2.size(); ++k) {
    NoiseClass& noise_class = noise_classes[k];
    const auto count = static_cast<double>(noise_class.sizes_px.size());
    noise_class.variance_px2 = variance_of(noise_class.sizes_px);
    if (count > 0.0) noise_class.time_variance_px2 /= count;
    variances_px2[k] =
        static_cast<float>((count * noise_class.variance_px2 + lean_px * whole_px2) / (count + lean_px));
    time_variances_px2[k] = static_cast<float>(noise_class.time_variance_px2);
  }
  explain(noise_classes, noise);
  // Variance of a uniform distribution one depth unit wide; at disparity d, a unit is d^2 / product_units_px.
  const double product_units_px = stereo.focal_baseline_units_px();
  const auto rounding = static_cast<float>(1.0 / (12.0 * product_units_px * product_units_px));
  const auto fourth = [](float number) { return number * number * number * number; };
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    const float rounding_px2 = rounding * (fourth(change.before_px[i]) + fourth(change.after_px[i]));
    const float time_px2 = change.deviation_px[i] * change.deviation_px[i];
    const float excess_px2 = std::max(0.0F, time_px2 - time_variances_px2[classes[i]]);
    const float variance_px2 = std::max(variances_px2[classes[i]], rounding_px2) +
                               excess_px2 / independent_at_least + drift_variance_px2[i];
    noise.deviation_px[i] = change.judged[i] != 0 ? std::sqrt(variance_px2) : 0.0F;
  }
  return noise;
}

}  // namespace rva
