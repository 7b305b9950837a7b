#include "inspect/noise_watch.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

#include "core/quantile.hpp"
#include "core/units.hpp"
#include "detect/calibrated/calibrated.hpp"
#include "detect/findings/detection.hpp"

namespace rva {

NoiseWatch::NoiseWatch(const CaptureInfo& info)
    : stereo_(stereo_scale(info)),
      focal_px_(info.depth.fx),
      even_(info.depth.width, info.depth.height),
      odd_(info.depth.width, info.depth.height) {}

void NoiseWatch::add(const DepthImage& frame) {
  (frames() % 2 == 0 ? even_ : odd_).add(frame);
  if (first_.empty()) first_ = frame;
  varies_ = varies_ || frame != first_;
}

bool NoiseWatch::frozen() const {
  const auto measured = [](std::uint16_t depth) { return depth != no_depth; };
  return frames() >= 2 && !varies_ && std::ranges::any_of(first_.pixels(), measured);
}

NoiseSoFar NoiseWatch::measure() const {
  assert(frames() >= 2);
  NoiseSoFar noise;
  noise.frames = frames();
  std::vector<double> std_mm;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < even_.size(); ++i) {
    seen += even_.seen(i) ? 1U : 0U;
    if (even_.count(i) > 1) std_mm.push_back(even_.standard_deviation(i) * stereo_.unit_m * mm_per_m);
  }
  noise.measured = static_cast<double>(seen) / static_cast<double>(even_.size());
  if (!std_mm.empty()) noise.median_std_mm = quantile(std_mm, 0.5);
  CalibratedComparison halves = compare_calibrated(even_, odd_, stereo_, {});
  noise.findable = std::move(halves.levels);
  state_widths(noise.findable, focal_px_);
  noise.findable.findable = findable_shares(halves.level_of_detection_mm, halves.comparison.final_m,
                                            noise.findable.window_px, focal_px_);
  noise.least_mm = std::move(halves.level_of_detection_mm);
  return noise;
}

}  // namespace rva
