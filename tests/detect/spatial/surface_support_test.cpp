#include "detect/spatial/surface_support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "capture/memory_capture.hpp"
#include "sim/simulated_camera.hpp"
#include "tests/sim/simulated_frames.hpp"
#include "tests/sim/small_scenes.hpp"

namespace rva {
namespace {

constexpr double wall_m = 0.6;
constexpr double false_findings = 0.05;

Scene empty_room() { return test::room_with_wall(wall_m); }

/// A bar before the wall, 60 mm long and deep; one pixel is 1.4 mm there.
Scene room_with_bar(double height_m) {
  Scene scene = empty_room();
  const Transform world_from_camera =
      SimulatedCamera(scene, test::quick(), 0, ColorFrames::none).world_from_camera();
  scene.objects.push_back(test::box_at("bar", world_from_camera * Eigen::Vector3d(0, 0, wall_m - 0.03),
                                       {0.06, 0.06, height_m}, test::grainy));
  return scene;
}

Captures side_of(const Scene& scene, int captures, std::uint64_t seed) {
  Captures side;
  for (int k = 0; k < captures; ++k) {
    SimulatedCamera camera(scene, test::quick(), seed + static_cast<std::uint64_t>(k), ColorFrames::none);
    CameraFrame frame = *camera.wait_for_frame();
    std::vector<MemoryFrame> frames;
    frames.push_back({std::move(frame.depth), {}, std::move(frame.infrared), {}});
    side.push_back(std::make_unique<MemoryCapture>(camera.info(), std::move(frames)));
  }
  return side;
}

Image<float> true_depth_m(const Scene& scene) {
  return SimulatedCamera(scene, test::quick(), 0, ColorFrames::none).true_view().depth_m;
}

/// The changes between two scenes by depth, with correct depth in both.
Comparison claim(const Scene& before, const Scene& after) {
  const Image<float> initial_m = true_depth_m(before);
  const Image<float> final_m = true_depth_m(after);
  Comparison comparison(initial_m.width(), initial_m.height());
  comparison.evidence_is_rarity = true;
  for (std::size_t i = 0; i < initial_m.size(); ++i) {
    if (final_m[i] > initial_m[i] - 0.005F) continue;
    comparison.changed[i] = mask_set;
    comparison.evidence[i] = 1.0F;
  }
  comparison.initial_m = initial_m;
  comparison.final_m = final_m;
  return comparison;
}

PlacedCaptures placed(const Captures& initial, const Captures& final, const Image<float>& final_m) {
  PlacedCaptures placed;
  placed.first_from_initial.assign(initial.size(), Transform::Identity());
  placed.first_from_final.assign(final.size(), Transform::Identity());
  const CaptureInfo& info = final.front()->info();
  placed.final_view = {info.depth, stereo_scale(info), Image<float>(final_m.width(), final_m.height()),
                       Image<float>(final_m.width(), final_m.height())};
  for (std::size_t i = 0; i < final_m.size(); ++i) {
    if (final_m[i] > 0.0F)
      placed.final_view.disparity_px[i] =
          static_cast<float>(stereo_scale(info).focal_baseline_m_px) / final_m[i];
  }
  return placed;
}

// The share of the claimed pixels that stay.
double kept(const Scene& before, const Scene& after, Comparison comparison, int captures) {
  const Captures initial = side_of(before, captures, 1);
  const Captures final = side_of(after, captures, 100);
  const auto claimed = std::ranges::count(comparison.changed.pixels(), mask_set);
  EXPECT_GT(claimed, 100);
  keep_supported(initial, final, placed(initial, final, comparison.final_m), Transform::Identity(),
                 false_findings, comparison);
  const auto stays = std::ranges::count(comparison.changed.pixels(), mask_set);
  return static_cast<double>(stays) / static_cast<double>(claimed);
}

constexpr double thick_m = 0.02;
constexpr double thin_m = 0.0055;  // four pixels
const Transform elsewhere(Eigen::Translation3d(0.05, 0.0, 0.0));

TEST(SurfaceSupport, WhatBothSidesSawStays) {
  const Comparison comparison = claim(empty_room(), room_with_bar(thick_m));
  EXPECT_EQ(kept(empty_room(), room_with_bar(thick_m), comparison, 1), 1.0);
  EXPECT_EQ(kept(empty_room(), room_with_bar(thick_m), comparison, 4), 1.0);
}

TEST(SurfaceSupport, WhatOneSidesMatcherMadeUpIsTakenBack) {
  const Comparison comparison = claim(empty_room(), room_with_bar(thick_m));
  EXPECT_EQ(kept(empty_room(), empty_room(), comparison, 1), 0.0);
  EXPECT_EQ(kept(room_with_bar(thick_m), room_with_bar(thick_m), comparison, 1), 0.0);
}

TEST(SurfaceSupport, ALineOfFourPixelsStaysWhereTheCameraCameBack) {
  const Comparison comparison = claim(empty_room(), room_with_bar(thin_m));
  EXPECT_EQ(kept(empty_room(), room_with_bar(thin_m), comparison, 1), 1.0);
  EXPECT_EQ(kept(empty_room(), room_with_bar(thin_m), comparison, 4), 1.0);
}

// An edge that both matchers put elsewhere looks like this. The camera stood still all the same, and is only
// stated to have moved along the wall.
TEST(SurfaceSupport, ALineOfFourPixelsFromElsewhereNeedsSeveralViews) {
  const Captures initial = side_of(empty_room(), 1, 1);
  const Captures final = side_of(room_with_bar(thin_m), 1, 100);
  Comparison comparison = claim(empty_room(), room_with_bar(thin_m));
  PlacedCaptures where = placed(initial, final, comparison.final_m);
  where.first_from_initial.front() = elsewhere;
  keep_supported(initial, final, where, elsewhere, false_findings, comparison);
  EXPECT_EQ(std::ranges::count(comparison.changed.pixels(), mask_set), 0);

  comparison = claim(empty_room(), room_with_bar(thick_m));
  const Captures thick = side_of(room_with_bar(thick_m), 1, 100);
  where = placed(initial, thick, comparison.final_m);
  where.first_from_initial.front() = elsewhere;
  keep_supported(initial, thick, where, elsewhere, false_findings, comparison);
  EXPECT_GT(std::ranges::count(comparison.changed.pixels(), mask_set), 100);
}

// A post that stands far before the wall, seen from its end: 5 mm are 8 pixels at a quarter of a metre.
std::ptrdiff_t kept_of_post(double side_m) {
  Scene after = empty_room();
  const Transform world_from_camera =
      SimulatedCamera(after, test::quick(), 0, ColorFrames::none).world_from_camera();
  after.objects.push_back(test::box_at("post", world_from_camera * Eigen::Vector3d(0, 0, 0.25 + 0.05),
                                       {side_m, 0.1, side_m}, test::grainy));
  const Captures initial = side_of(empty_room(), 1, 1);
  const Captures final = side_of(after, 1, 100);
  Comparison comparison = claim(empty_room(), after);
  EXPECT_GT(std::ranges::count(comparison.changed.pixels(), mask_set), 0);
  keep_supported(initial, final, placed(initial, final, comparison.final_m), Transform::Identity(),
                 false_findings, comparison);
  return std::ranges::count(comparison.changed.pixels(), mask_set);
}

TEST(SurfaceSupport, ASpikeThatIsNarrowerThanAnyDebrisIsAWrongMatch) {
  EXPECT_EQ(kept_of_post(0.0015), 0);
  EXPECT_GT(kept_of_post(0.005), 40);
}

TEST(SurfaceSupport, MakesWhatStaysRarer) {
  EXPECT_EQ(rarity_of_support(1, Transform::Identity()), 1.0);
  EXPECT_EQ(rarity_of_support(1, elsewhere), 20.0);
  const Captures initial = side_of(empty_room(), 4, 1);
  const Captures final = side_of(room_with_bar(thick_m), 4, 100);
  Comparison comparison = claim(empty_room(), room_with_bar(thick_m));
  keep_supported(initial, final, placed(initial, final, comparison.final_m), Transform::Identity(),
                 false_findings, comparison);
  EXPECT_NEAR(*std::ranges::max_element(comparison.evidence.pixels()), 1.0 + std::log10(20.0), 1e-5);
}

}  // namespace
}  // namespace rva
