// Distances and lengths measured in a simulated bay lie within their stated uncertainty of the truth.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "core/random.hpp"
#include "core/units.hpp"
#include "measure/quantity.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"

namespace rva {
namespace {

/// A point that was measured, and where its surface truly is.
struct Compared {
  SurfacePoint measured;
  Eigen::Vector3d truth_m;
};

// The pixels are exact, and so is the simulated camera's scale.
MeasureOptions matching_alone() {
  MeasureOptions options;
  options.pointing_px = 0.0;
  options.calibration_share = 0.0;
  return options;
}

// On a grid over the view, except near edges.
std::vector<Compared> compared_points(int frames) {
  SimulatedCamera camera(load_scene(std::filesystem::path(RVA_SCENES) / "three-tools.yaml"), {}, 11,
                         ColorFrames::none);
  const CaptureInfo info = camera.info();
  const TrueView truth = camera.true_view();
  DepthStatistics statistics(info.depth.width, info.depth.height);
  for (int i = 0; i < frames; ++i) statistics.add(camera.wait_for_frame()->depth);
  const UncertainView view = uncertain_view(statistics, info.depth, stereo_scale(info), matching_alone());
  std::vector<Compared> points;
  for (int v = 10; v < info.depth.height; v += 23) {
    for (int u = 60; u < info.depth.width; u += 23) {
      const PointOrReason found = surface_point(view, {u, v}, matching_alone());
      const auto* point = std::get_if<SurfacePoint>(&found);
      const double depth_m = truth.depth_m(u, v);
      if (point == nullptr || point->near_edge || depth_m <= 0.0) continue;
      points.push_back({*point, info.depth.deproject({u, v}, depth_m)});
    }
  }
  return points;
}

bool covers(const Quantity& measured, double truth_m) {
  return std::abs(measured.value_mm - mm_per_m * truth_m) <= measured.expanded_mm();
}

TEST(MeasuredTruth, LiesWithinTheUncertainty) {
  for (const int frames : {1, 8}) {
    const std::vector<Compared> points = compared_points(frames);
    const auto count = static_cast<double>(points.size());
    ASSERT_GT(count, 400.0);
    Random random(5);
    int distances = 0;
    int lengths = 0;
    for (const Compared& one : points) {
      const Compared& other = points[static_cast<std::size_t>(random.uniform() * count)];
      if (covers(distance_of(one.measured, matching_alone()), one.truth_m.norm())) ++distances;
      if (covers(length_between(one.measured, other.measured, matching_alone()),
                 (one.truth_m - other.truth_m).norm()))
        ++lengths;
    }
    for (const int covered : {distances, lengths}) {
      EXPECT_GE(covered / count, 0.90) << frames << " frames";
      EXPECT_LE(covered / count, 0.99) << frames << " frames";
    }
  }
}

}  // namespace
}  // namespace rva
