#include "bench/frames.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace rva::bench {
namespace {

constexpr int width = 848;
constexpr int height = 480;
constexpr double units_per_m = 10000.0;

// Steps of 60 columns on a slope, similar to a bay with ribs seen from its access hole.
double depth_m(int u, int v) { return 0.4 + 0.1 * ((u / 60) % 4) + 1.2 * v / height; }

// Holes like those of a real camera: patches without measurements, a flickering rim around each, and
// occasional single pixels elsewhere. About 5 % of the measurements are missing; within 8 frames, 5 % of
// the pixels flicker and 15 % of all runs of 16 pixels have a hole (20 to 25 % in recordings of a D400
// and a Kinect).
double hole_share(int u, int v) {
  const double distance_px = std::hypot(u % 106 - 53, v % 96 - 48);
  if (distance_px < 11.0) return 1.0;
  return distance_px < 18.0 ? 0.2 : 2e-5;
}

}  // namespace

std::vector<DepthImage> make_frames(int count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::vector<DepthImage> frames(static_cast<std::size_t>(count), DepthImage(width, height));
  for (DepthImage& frame : frames) {
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const bool at_step = u % 60 < 2;
        const double z = depth_m(at_step && uniform(random) < 0.5 ? u + 60 : u, v);
        const double noisy = (z + 0.003 * z * z * normal(random)) * units_per_m;
        const bool hole = uniform(random) < hole_share(u, v);
        frame(u, v) = hole ? no_depth : static_cast<std::uint16_t>(std::lround(noisy));
      }
    }
  }
  return frames;
}

Mask make_mask(int blobs, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> column(0, width - 10);
  std::uniform_int_distribution<int> row(0, height - 10);
  std::uniform_int_distribution<int> side(1, 8);
  Mask mask(width, height);
  for (int k = 0; k < blobs; ++k) {
    const int left = column(random);
    const int top = row(random);
    const int blob_width = side(random);
    const int blob_height = side(random);
    for (int v = top; v < top + blob_height; ++v) {
      for (int u = left; u < left + blob_width; ++u) mask(u, v) = mask_set;
    }
  }
  return mask;
}

}  // namespace rva::bench
