// Two captures from one pose, made by hand: a surface, what was put on it, and white noise in disparity.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

#include "core/random.hpp"
#include "depth/depth_statistics.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva::test {

inline constexpr StereoScale stereo{.focal_baseline_m_px = 21.25, .unit_m = 0.0001};

struct NoisyCapture {
  int width = 424;
  int height = 240;
  int frames = 10;
  double noise_px = 0.05;  // of one frame
  std::function<double(int u, int v)> disparity_px = [](int /*u*/, int /*v*/) { return 25.0; };

  [[nodiscard]] DepthStatistics take(std::uint64_t seed) const {
    DepthStatistics statistics(width, height);
    Random random(seed);
    for (int frame = 0; frame < frames; ++frame) {
      DepthImage depth(width, height);
      for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
          const double disparity = disparity_px(u, v);
          if (disparity <= 0.0) continue;
          const double depth_m = stereo.depth_m(disparity + noise_px * random.normal());
          depth(u, v) = static_cast<std::uint16_t>(std::lround(depth_m / stereo.unit_m));
        }
      }
      statistics.add(depth);
    }
    return statistics;
  }
};

}  // namespace rva::test
