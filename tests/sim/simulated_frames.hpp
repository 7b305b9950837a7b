// A simulated camera's settings and what its frames show.
#pragma once

#include <algorithm>
#include <vector>

#include "depth/image.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva::test {

/// One ray a pixel.
inline StereoSensorOptions quick() {
  StereoSensorOptions options;
  options.supersampling = 1;
  return options;
}

/// Nothing but the imagers' own noise.
inline StereoSensorOptions without_hard_noise() {
  StereoSensorOptions options = quick();
  options.speckle = options.wander = options.levels = options.flicker = options.drift_px = 0.0;
  return options;
}

/// Median of the depths around the image's middle, in metres; 0 where most pixels have none.
inline double middle_depth_m(const DepthImage& depth) {
  std::vector<std::uint16_t> depths;
  for (int v = 215; v < 265; ++v) {
    for (int u = 399; u < 449; ++u) depths.push_back(depth(u, v));
  }
  std::nth_element(depths.begin(), depths.begin() + static_cast<long>(depths.size() / 2), depths.end());
  return depths[depths.size() / 2] * 1e-4;
}

}  // namespace rva::test
