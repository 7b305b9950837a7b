#include "sim/sensor/dot_pattern.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace rva {

namespace {

// Lengths are tangents: 0.001 corresponds to 0.4 px of an imager with a focal length of 425 px.
constexpr double texel = 0.0010;
// Full width at half maximum: 4 mm at 1 m, as pictures of the pattern show.
constexpr double dot_sigma = 0.0017;
constexpr double jitter = 0.36;             // to each side, as a share of the cell
constexpr double brightness_spread = 0.35;  // to each side of the mean

}  // namespace

DotPattern::DotPattern(int dots, double dot_share, std::uint64_t seed)
    : table_(static_cast<int>(2 * half_width / texel) + 2, static_cast<int>(2 * half_height / texel) + 2,
             static_cast<float>(dots > 0 ? 1.0 - dot_share : 1.0)) {
  if (dots <= 0) return;
  const double cell = std::sqrt(4.0 * half_width * half_height / dots);
  // The peak of a Gaussian that contains the cell's whole share of the light.
  const double mean_peak = dot_share * cell * cell / (2.0 * M_PI * dot_sigma * dot_sigma);
  Random random(seed);
  for (double y = -half_height + cell / 2; y < half_height; y += cell) {
    for (double x = -half_width + cell / 2; x < half_width; x += cell) {
      const double dx = random.uniform(-jitter, jitter) * cell;
      const double dy = random.uniform(-jitter, jitter) * cell;
      const double brightness = random.uniform(1.0 - brightness_spread, 1.0 + brightness_spread);
      draw_dot({x + dx, y + dy}, mean_peak * brightness);
    }
  }
}

void DotPattern::draw_dot(const Eigen::Vector2d& center, double peak) {
  const Eigen::Vector2d at = (center + Eigen::Vector2d(half_width, half_height)) / texel;
  constexpr int reach = static_cast<int>(4 * dot_sigma / texel) + 1;
  const int u0 = static_cast<int>(at.x());
  const int v0 = static_cast<int>(at.y());
  for (int v = std::max(0, v0 - reach); v <= std::min(table_.height() - 1, v0 + reach); ++v) {
    for (int u = std::max(0, u0 - reach); u <= std::min(table_.width() - 1, u0 + reach); ++u) {
      const double squared = (Eigen::Vector2d(u, v) - at).squaredNorm() * texel * texel;
      table_(u, v) += static_cast<float>(peak * std::exp(-0.5 * squared / (dot_sigma * dot_sigma)));
    }
  }
}

float DotPattern::at(float x, float y) const {
  const float u = (x + static_cast<float>(half_width)) / static_cast<float>(texel);
  const float v = (y + static_cast<float>(half_height)) / static_cast<float>(texel);
  // Checked before the conversion to int: it is false for NaN and for values that an int cannot represent.
  const bool inside = u >= 0.0F && v >= 0.0F && u < static_cast<float>(table_.width() - 1) &&
                      v < static_cast<float>(table_.height() - 1);
  if (!inside) return 0.0F;
  const int column = static_cast<int>(u);
  const int row = static_cast<int>(v);
  const float right = u - static_cast<float>(column);
  const float down = v - static_cast<float>(row);
  const float* const above = &table_(column, row);
  const float* const below = &table_(column, row + 1);
  const float upper = above[0] + right * (above[1] - above[0]);
  const float lower = below[0] + right * (below[1] - below[0]);
  return upper + down * (lower - upper);
}

}  // namespace rva
