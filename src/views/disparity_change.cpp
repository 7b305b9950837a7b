#include "views/disparity_change.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "core/quantile.hpp"

namespace rva {
namespace {

constexpr float jump = 10.0F;  // as a multiple of the deviation of the median pixel
constexpr float nothing = 0.0F;

// Converts depth statistics to mean disparities, and adds the variance of a single frame to `variance_px2`.
class Converter {
 public:
  Converter(const DepthStatistics& depth, const StereoScale& stereo)
      : depth_(depth),
        focal_baseline_units_px_(static_cast<float>(stereo.focal_baseline_units_px())),
        share_of_frames_(depth.frames() == 0 ? 0.0F : 1.0F / static_cast<float>(depth.frames())),
        share_of_(depth.frames() + 1) {
    for (std::size_t count = 1; count < share_of_.size(); ++count)
      share_of_[count] = 1.0F / static_cast<float>(count);
  }

  [[nodiscard]] float share_seen(std::size_t i) const {
    return static_cast<float>(depth_.count(i)) * share_of_frames_;
  }

  // The standard deviation is scaled by the derivative of disparity by depth, -d / z.
  // Equations 1 and 2 of docs/math.md.
  void convert(std::size_t i, float& disparity_px, float& variance_px2) const {
    if (!depth_.seen(i)) return;
    const float share = share_of_[depth_.count(i)];
    const float by_mean = 1.0F / (static_cast<float>(depth_.sum(i)) * share);
    const float slope = focal_baseline_units_px_ * by_mean * by_mean * share;
    disparity_px = focal_baseline_units_px_ * by_mean;
    variance_px2 += static_cast<float>(depth_.scaled_variance(i)) * slope * slope;
  }

 private:
  const DepthStatistics& depth_;
  float focal_baseline_units_px_;
  float share_of_frames_;
  std::vector<float> share_of_;
};

void leave_out(DisparityChange& change, std::size_t i) {
  change.judged[i] = 0;
  change.deviation_px[i] = nothing;
}

void leave_out_margin(DisparityChange& change) {
  const int width = change.judged.width();
  const int height = change.judged.height();
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const bool inside = inside_margin(u, v, width, height);
      if (inside) continue;
      leave_out(change, static_cast<std::size_t>(&change.judged(u, v) - change.judged.data()));
      change.lost(u, v) = nothing;
    }
  }
}

void leave_out_jumps(DisparityChange& change) {
  constexpr std::size_t sampling = 17;
  std::vector<float> deviations_px;
  for (std::size_t i = 0; i < change.judged.size(); i += sampling) {
    if (change.judged[i] != 0) deviations_px.push_back(change.deviation_px[i]);
  }
  if (deviations_px.empty()) return;
  const float most_px = jump * quantile(deviations_px, 0.5);
  if (most_px <= 0.0F) return;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (change.deviation_px[i] > most_px) leave_out(change, i);
  }
}

}  // namespace

void leave_out(DisparityChange& change, Mask left_out) {
  const auto count = static_cast<std::size_t>(std::ranges::count(left_out.pixels(), mask_set));
  const bool enough_remains = 2 * count <= left_out.size();
  for (std::size_t i = 0; enough_remains && i < left_out.size(); ++i) {
    if (left_out[i] == 0) continue;
    leave_out(change, i);
    change.lost[i] = nothing;
  }
  change.left_out = std::move(left_out);
}

void forget_losses(DisparityChange& change) { std::ranges::fill(change.lost.pixels(), nothing); }

// Equation 7 of docs/math.md.
DisparityChange disparity_change(const DepthStatistics& initial, const DepthStatistics& final,
                                 const StereoScale& stereo) {
  assert(initial.width() == final.width() && initial.height() == final.height());
  DisparityChange change(final.width(), final.height());
  change.frames = std::min(initial.frames(), final.frames());
  const Converter before(initial, stereo);
  const Converter after(final, stereo);
  for (std::size_t i = 0; i < final.size(); ++i) {
    if (change.frames > 0) change.lost[i] = before.share_seen(i) - after.share_seen(i);
    float variance_px2 = 0.0F;
    before.convert(i, change.before_px[i], variance_px2);
    after.convert(i, change.after_px[i], variance_px2);
    if (change.before_px[i] <= nothing || change.after_px[i] <= nothing) continue;
    change.judged[i] = mask_set;
    change.deviation_px[i] = std::sqrt(variance_px2);
  }
  leave_out_margin(change);
  leave_out_jumps(change);
  return change;
}

}  // namespace rva
