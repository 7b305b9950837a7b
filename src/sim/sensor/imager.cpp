#include "sim/sensor/imager.hpp"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <vector>

#include "core/parallel.hpp"
#include "core/random.hpp"

namespace rva {

namespace {

constexpr int greatest_level = 1023;
constexpr std::size_t quantiles = 4096;

/// Quantiles of the standard normal distribution at equal steps of probability, scaled to a variance of
/// exactly 1. A random index draws from the distribution at the cost of a table lookup.
const std::array<float, quantiles>& normal_quantiles() {
  static const std::array<float, quantiles> table = [] {
    std::array<float, quantiles> values{};
    double squares = 0.0;
    for (std::size_t i = 0; i < quantiles; ++i) {
      const double probability = (static_cast<double>(i) + 0.5) / quantiles;
      const double value = -std::sqrt(2.0) * boost::math::erfc_inv(2.0 * probability);
      values[i] = static_cast<float>(value);
      squares += value * value;
    }
    const auto scale = static_cast<float>(1.0 / std::sqrt(squares / quantiles));
    for (float& value : values) value *= scale;
    return values;
  }();
  return table;
}

void fill_normal(Random& random, std::vector<float>& values) {
  const std::array<float, quantiles>& table = normal_quantiles();
  constexpr int draws = 5;  // 12 bits each, from the 64 bits of a random number
  for (std::size_t i = 0; i < values.size(); i += draws) {
    std::uint64_t bits = random.bits();
    for (std::size_t j = i; j < std::min(i + draws, values.size()); ++j, bits >>= 12U)
      values[j] = table[bits % quantiles];
  }
}

}  // namespace

double automatic_exposure(const ImagerLight& view, const StereoSensorOptions& options) {
  constexpr std::size_t step = 7;  // a sample of the pixels suffices for a quantile
  std::vector<float> light;
  light.reserve(view.steady.size() / step + 1);
  for (std::size_t i = 0; i < view.steady.size(); i += step)
    light.push_back(view.steady[i] + view.projected[i]);
  const auto bright = light.begin() + static_cast<std::ptrdiff_t>(light.size() * 95 / 100);
  std::nth_element(light.begin(), bright, light.end());
  const double wanted_e = options.exposure_target * options.full_well_e / options.gain;
  return *bright * longest_exposure_e > wanted_e ? wanted_e / *bright : longest_exposure_e;
}

InfraredImage expose(const ImagerLight& view, const Speckle& speckle, double exposure_e,
                     const StereoSensorOptions& options, std::uint64_t seed) {
  const int width = view.steady.width();
  InfraredImage image(width, view.steady.height());
  const auto exposure = static_cast<float>(exposure_e);
  const auto read_variance = static_cast<float>(options.read_noise_e * options.read_noise_e);
  const auto levels_per_e = static_cast<float>(options.gain * greatest_level / options.full_well_e);
  parallel_bands(view.steady.height(), [&](int first, int end) {
    std::vector<float> factor(static_cast<std::size_t>(width));
    std::vector<float> noise(static_cast<std::size_t>(width));
    for (int v = first; v < end; ++v) {
      Random random(mix(seed, v));
      fill_normal(random, noise);
      speckle.row(v, factor.data());
      const float* const steady = &view.steady(0, v);
      const float* const projected = &view.projected(0, v);
      std::uint16_t* const out = &image(0, v);
      for (int u = 0; u < width; ++u) {
        const auto i = static_cast<std::size_t>(u);
        const float electrons = exposure * (steady[u] + projected[u] * factor[i]);
        const float noisy = electrons + noise[i] * std::sqrt(electrons + read_variance);
        const float level = std::clamp(noisy * levels_per_e, 0.0F, static_cast<float>(greatest_level));
        out[u] = static_cast<std::uint16_t>(level + 0.5F);
      }
    }
  });
  return image;
}

}  // namespace rva
