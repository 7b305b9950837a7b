#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/simulated_camera.hpp"
#include "tests/sim/simulated_frames.hpp"
#include "tests/sim/small_scenes.hpp"

namespace rva {
namespace {

DepthImage depth_at(double distance_m) {
  SimulatedCamera camera(test::room_with_wall(distance_m), test::quick(), 1, ColorFrames::none);
  return camera.wait_for_frame()->depth;
}

/// Some frames of one capture of a wall at 1 m.
std::vector<DepthImage> captured(const StereoSensorOptions& options, std::uint64_t seed) {
  SimulatedCamera camera(test::room_with_wall(1.0), options, seed, ColorFrames::none);
  std::vector<DepthImage> frames;
  for (int k = 0; k < 3; ++k) frames.push_back(camera.wait_for_frame()->depth);
  return frames;
}

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
};

Moments moments_of(const std::vector<DepthImage>& frames, int u, int v) {
  const auto count = static_cast<double>(frames.size());
  Moments moments;
  for (const DepthImage& frame : frames) moments.mean += frame(u, v) / count;
  for (const DepthImage& frame : frames)
    moments.variance += std::pow(frame(u, v) - moments.mean, 2) / (count - 1.0);
  return moments;
}

/// By how much two captures' means differ, squared, over what the noise within them explains.
double excess_of(const std::vector<DepthImage>& a, const std::vector<DepthImage>& b) {
  double between = 0.0;
  double within = 0.0;
  for (int v = 140; v < 340; v += 7) {
    for (int u = 200; u < 650; u += 7) {
      const Moments of_a = moments_of(a, u, v);
      const Moments of_b = moments_of(b, u, v);
      // A few pixels have no depth, or a wrong one, in one of the frames.
      constexpr double most = 100.0 * 100.0;
      if (of_a.variance > most || of_b.variance > most) continue;
      between += std::pow(of_a.mean - of_b.mean, 2);
      within += (of_a.variance + of_b.variance) / static_cast<double>(a.size());
    }
  }
  return between / within;
}

TEST(SimulatedNoise, WithoutItsHardPartsTwoCapturesAgree) {
  StereoSensorOptions options = test::without_hard_noise();
  const std::vector<DepthImage> first = captured(options, 1);
  EXPECT_NEAR(excess_of(first, captured(options, 2)), 1.0, 0.25);
  options.drift_px = 0.3;
  EXPECT_GT(excess_of(first, captured(options, 3)), 3.0);
}

TEST(SimulatedDepth, IsBlindTooNearAndNotFartherAway) {
  // Searched are 126 px: 425 px * 50 mm / 126 px = 169 mm.
  const DepthImage near = depth_at(0.15);
  EXPECT_EQ(test::middle_depth_m(near), 0.0);
  EXPECT_EQ(
      std::count_if(near.pixels().begin(), near.pixels().end(), [](int d) { return d > 0 && d < 1650; }), 0);
  EXPECT_NEAR(test::middle_depth_m(depth_at(0.19)), 0.19, 0.002);
}

}  // namespace
}  // namespace rva
