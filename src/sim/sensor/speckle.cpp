#include "sim/sensor/speckle.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "core/random.hpp"

namespace rva {

namespace {

// The sum of four uniform numbers is close enough to a normal distribution, and fast to compute.
void add_random_field(double deviation, std::uint64_t seed, Image<float>& field) {
  if (deviation <= 0.0) return;
  const auto scale = static_cast<float>(deviation / 65536.0 / std::sqrt(4.0 / 12.0));
  parallel_bands(field.height(), [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      Random random(mix(seed, v));
      for (int u = 0; u < field.width(); ++u) {
        const std::uint64_t bits = random.bits();
        const auto sum = static_cast<std::int32_t>((bits & 0xFFFF) + ((bits >> 16U) & 0xFFFF) +
                                                   ((bits >> 32U) & 0xFFFF) + (bits >> 48U));
        field(u, v) += scale * static_cast<float>(sum - 2 * 65535);
      }
    }
  });
}

// @param part number of the field within the speckle; each has a random stream of its own
Image<float> random_field(int width, int height, double deviation, const std::vector<SpeckleShare>& view,
                          std::uint64_t part) {
  Image<float> field(width, height);
  for (const SpeckleShare& share : view)
    add_random_field(share.weight * deviation, mix(share.seed, part), field);
  return field;
}

}  // namespace

std::vector<SpeckleShare> speckle_shares(const PanTilt& turn, double speckle_turn_deg,
                                         std::uint64_t stand_seed) {
  const double pan = turn.pan_deg / speckle_turn_deg;
  const double tilt = turn.tilt_deg / speckle_turn_deg;
  std::vector<SpeckleShare> shares;
  double squares = 0.0;
  for (const double near_pan : {std::floor(pan), std::floor(pan) + 1.0}) {
    for (const double near_tilt : {std::floor(tilt), std::floor(tilt) + 1.0}) {
      const double weight = (1.0 - std::abs(pan - near_pan)) * (1.0 - std::abs(tilt - near_tilt));
      if (weight <= 0.0) continue;
      shares.push_back({mix(stand_seed, std::llround(near_pan), std::llround(near_tilt)), weight});
      squares += weight * weight;
    }
  }
  for (SpeckleShare& share : shares) share.weight /= std::sqrt(squares);
  return shares;
}

Speckle::Speckle(int width, int height, const StereoSensorOptions& options,
                 const std::vector<SpeckleShare>& view, std::uint64_t capture_seed)
    : options_(options),
      width_(width),
      capture_seed_(capture_seed),
      fixed_(random_field(width, height, options.speckle, view, 0)),
      patch_levels_(width / patch_px + 1, height / patch_px + 1) {
  // The fields belong to the view: two captures of one view differ in the weights of the fields only.
  if (options.wander > 0.0) {
    for (int i = 0; i < wander_fields; ++i)
      wandering_.push_back(random_field(width, height, options.wander / std::sqrt(wander_fields), view,
                                        std::uint64_t{1} + static_cast<std::uint64_t>(i)));
  }
  if (options.levels > 0.0) {
    for (int i = 0; i < level_patterns; ++i)
      patterns_.push_back(random_field(width, height, options.levels, view,
                                       std::uint64_t{100} + static_cast<std::uint64_t>(i)));
  }
}

void Speckle::start() {
  Random random(mix(capture_seed_, 0x57A7));
  for (double& weight : weights_) weight = random.normal();
  for (std::uint8_t& level : patch_levels_.pixels())
    level = static_cast<std::uint8_t>(random.bits() % level_patterns);
}

void Speckle::advance() {
  if (!started_) {
    start();
    started_ = true;
    return;
  }
  ++frame_;
  Random random(mix(capture_seed_, 0xF4A3, frame_));
  // First-order autoregression, correlated over `wander_frames`, with a constant variance of 1.
  const double kept = std::exp(-1.0 / options_.wander_frames);
  for (double& weight : weights_) weight = kept * weight + std::sqrt(1.0 - kept * kept) * random.normal();
  const double jump = 1.0 / options_.level_frames;
  for (std::uint8_t& level : patch_levels_.pixels()) {
    if (random.uniform() < jump)
      level = static_cast<std::uint8_t>((level + 1 + random.bits() % (level_patterns - 1)) % level_patterns);
  }
}

void Speckle::row(int v, float* factor) const {
  const float* const fixed = &fixed_(0, v);
  for (int u = 0; u < width_; ++u) factor[u] = 1.0F + fixed[u];
  for (std::size_t i = 0; i < wandering_.size(); ++i) {
    const float* const field = &wandering_[i](0, v);
    const auto weight = static_cast<float>(weights_[i]);
    for (int u = 0; u < width_; ++u) factor[u] += weight * field[u];
  }
  for (int first = 0; first < width_ && !patterns_.empty(); first += patch_px) {
    const float* const pattern = &patterns_[patch_levels_(first / patch_px, v / patch_px)](0, v);
    for (int u = first; u < std::min(first + patch_px, width_); ++u) factor[u] += pattern[u];
  }
  for (int u = 0; u < width_; ++u) factor[u] = std::max(0.0F, factor[u]);
}

}  // namespace rva
