#include "sim/sensor/infrared_renderer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/sim/small_scenes.hpp"

namespace rva {
namespace {

Scene wall_scene(double z_m) {
  Scene scene;
  scene.objects.push_back(test::wall_at(z_m));
  return scene;
}

InfraredPair rendered(const Scene& scene, const Misalignment& misalignment = {}, int supersampling = 1) {
  const RayCaster rays(scene);
  return InfraredRenderer(scene, rays, {}).render(Transform::Identity(), misalignment, supersampling);
}

double squared_difference(const InfraredPair& pair, int shift, int down) {
  double sum = 0.0;
  for (int v = 60; v < 420; v += 3) {
    for (int u = 200; u < 700; ++u) {
      const double difference = static_cast<double>(pair.left.projected(u, v)) -
                                static_cast<double>(pair.right.projected(u - shift, v + down));
      sum += difference * difference;
    }
  }
  return sum;
}

/// Where a parabola through three values at -1, 0, 1 is least.
double vertex(double before, double at, double after) {
  return 0.5 * (before - after) / (before - 2 * at + after);
}

/// The shift between the images' middles at which they agree best.
double disparity_of(const InfraredPair& pair) {
  int best = 1;
  double least = squared_difference(pair, best, 0);
  for (int shift = 2; shift < 100; ++shift) {
    const double difference = squared_difference(pair, shift, 0);
    if (difference < least) best = shift;
    least = std::min(least, difference);
  }
  return best + vertex(squared_difference(pair, best - 1, 0), least, squared_difference(pair, best + 1, 0));
}

TEST(InfraredRenderer, AWallIsShiftedByFocalLengthTimesBaselineOverDistance) {
  for (const double z_m : {0.3, 1.0})
    EXPECT_NEAR(disparity_of(rendered(wall_scene(z_m))), 425 * 0.05 / z_m, 0.2);
}

TEST(InfraredRenderer, MisalignmentMovesTheRightImage) {
  const Scene scene = wall_scene(1.0);
  EXPECT_NEAR(disparity_of(rendered(scene, {.offset_px = 3.0})), 18.25, 0.2);
  const InfraredPair lower = rendered(scene, {.row_offset_px = 2.0});
  EXPECT_LT(squared_difference(lower, 21, 2), 0.5 * squared_difference(lower, 21, 0));
  EXPECT_EQ(lower.left.projected, rendered(scene).left.projected);
}

TEST(InfraredRenderer, MisalignmentGrowsTowardsTheEdgesAsStated) {
  Scene scene = wall_scene(1.0);
  scene.lighting.ambient = 1.0;
  // A dark step over the wall's right part, whose edge is sharp.
  scene.objects.push_back(test::box_at("step", {2.6, 0, 0.95}, {4, 12, 0.1}));
  const auto edge = [](const ImagerLight& view) {
    int u = 500;
    while (u < 847 && std::abs(view.steady(u, 240) - view.steady(u + 1, 240)) < 0.01F) ++u;
    return u;
  };
  scene.objects.back().parts[0].material = test::with_albedo(0.1);
  const int plain = edge(rendered(scene).right);
  ASSERT_LT(plain, 800);
  const double share = (plain - 423.5) / 424.0;
  EXPECT_NEAR(edge(rendered(scene, {.scale_px = 40.0}).right) - plain, 40.0 * share, 4.0);
  EXPECT_NEAR(edge(rendered(scene, {.offset_px = 5.0}).right) - plain, 5, 1);
}

TEST(InfraredRenderer, MovingThePatternMovesNoSurface) {
  const InfraredPair still = rendered(wall_scene(1.0));
  const InfraredPair moved = rendered(wall_scene(1.0), {.dots_px = 4.0});
  EXPECT_NEAR(disparity_of(moved), disparity_of(still), 0.05);
  const InfraredPair by_pattern{moved.left, still.left};
  EXPECT_NEAR(disparity_of(by_pattern), 4.0, 0.1);
}

TEST(InfraredRenderer, MoreRaysAreTheSameLight) {
  const auto mean = [](const Image<float>& image) {
    double sum = 0.0;
    for (const float light : image.pixels())
      sum += static_cast<double>(light) / static_cast<double>(image.size());
    return sum;
  };
  const ImagerLight coarse = rendered(wall_scene(0.7)).left;
  const ImagerLight fine = rendered(wall_scene(0.7), {}, 2).left;
  EXPECT_NEAR(mean(fine.projected), mean(coarse.projected), 0.01 * mean(coarse.projected));
  EXPECT_NEAR(mean(fine.steady), mean(coarse.steady), 1e-5);
  EXPECT_NE(fine.projected, coarse.projected);
}

TrueView looked(const Scene& scene) {
  const RayCaster rays(scene);
  return InfraredRenderer(scene, rays, {}).true_view(Transform::Identity());
}

TEST(TrueView, DepthOfATiltedPlaneIsThePlane) {
  Scene scene;
  scene.objects.push_back(test::box_at("plane", {0.1, -0.05, 1.5}, {12, 12, 0.02}));
  const Eigen::AngleAxisd turn(30.0 * std::numbers::pi / 180.0, Eigen::Vector3d(1, 2, 0.5).normalized());
  scene.objects[0].world_from_object.rotate(turn);
  const Eigen::Vector3d normal = turn * -Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d on_plane = scene.objects[0].world_from_object * Eigen::Vector3d(0, 0, -0.01);
  const TrueView view = looked(scene);
  const Intrinsics imager = stereo_rig({}).imager;
  double worst_m = 0.0;
  for (int v = 0; v < imager.height; ++v) {
    for (int u = 0; u < imager.width; ++u) {
      const double expected = normal.dot(on_plane) / normal.dot(imager.deproject({u, v}, 1.0));
      worst_m = std::max(worst_m, std::abs(static_cast<double>(view.depth_m(u, v)) - expected));
    }
  }
  EXPECT_LT(worst_m, 1e-4);
}

TEST(TrueView, LabelsAreOfTheNearestObject) {
  Scene scene;
  scene.objects.push_back(test::box_at("behind", {0, 0, 1.05}, {0.4, 0.4, 0.1}));
  scene.objects.push_back(test::box_at("in front", {0.1, 0, 0.55}, {0.1, 0.1, 0.1}));
  const TrueView view = looked(scene);
  EXPECT_EQ(view.labels(424, 240), Scene::label_of(0));
  EXPECT_NEAR(view.depth_m(424, 240), 1.0F, 1e-5F);
  EXPECT_EQ(view.labels(509, 240), Scene::label_of(1));
  EXPECT_NEAR(view.depth_m(509, 240), 0.5F, 1e-5F);
  EXPECT_EQ(view.labels(20, 20), 0);
  for (std::size_t i = 0; i < view.labels.size(); ++i)
    ASSERT_EQ(view.labels[i] == 0, view.depth_m[i] == 0.0F);
}

TEST(TrueView, MovesWithTheCamera) {
  const Scene scene = wall_scene(1.0);
  const RayCaster rays(scene);
  const InfraredRenderer renderer(scene, rays, {});
  const Transform nearer(Eigen::Translation3d(0.2, -0.1, 0.6));
  EXPECT_NEAR(renderer.true_view(nearer).depth_m(100, 50), 0.4F, 1e-5F);
  const Transform turned(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitY()));
  EXPECT_EQ(renderer.true_view(turned).labels(424, 240), 0);
}

}  // namespace
}  // namespace rva
