#include "sim/sensor/rectification_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/ray_caster.hpp"
#include "sim/sensor/infrared_renderer.hpp"
#include "tests/sim/small_scenes.hpp"

namespace rva {
namespace {

constexpr double stated_px = 0.1;

StereoSensorOptions bent() {
  StereoSensorOptions options;
  options.rectification_px = stated_px;
  return options;
}

RectificationError error_of(std::uint64_t seed) { return {bent(), stereo_rig(bent()).imager, seed}; }

TEST(RectificationError, HasTheDeviationThatTheOptionsStateAndNoMean) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  constexpr int cameras = 400;
  for (std::uint64_t seed = 0; seed < cameras; ++seed) {
    const Eigen::Vector2d at = error_of(seed).at(600.0, 100.0);
    sum += at / cameras;
    squares += at.cwiseAbs2() / cameras;
  }
  for (const double mean : sum) EXPECT_NEAR(mean, 0.0, 4.0 * stated_px / std::sqrt(cameras));
  for (const double square : squares) EXPECT_NEAR(std::sqrt(square), stated_px, 0.15 * stated_px);
}

TEST(RectificationError, VariesSlowlyOverTheImage) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RectificationError error = error_of(seed);
    for (int u = 0; u < 848; u += 40)
      EXPECT_LT((error.at(u, 200.0) - error.at(u + 1.0, 200.0)).norm(), 0.03 * stated_px);
    EXPECT_NE(error.at(0.0, 0.0), error.at(847.0, 479.0));
  }
}

TEST(RectificationError, IsNoneUnlessItIsAskedFor) {
  EXPECT_TRUE(RectificationError().is_none());
  EXPECT_TRUE(RectificationError({}, stereo_rig({}).imager, 1).is_none());
  EXPECT_EQ(RectificationError().at(10.0, 20.0), Eigen::Vector2d(0.0, 0.0));
}

TEST(RectificationError, MovesWhatBothImagersSee) {
  Scene scene;
  scene.objects.push_back(test::wall_at(1.0));
  const RayCaster rays(scene);
  StereoSensorOptions options;
  options.rectification_px = 3.0;
  const auto rendered = [&](const StereoSensorOptions& sensor) {
    return InfraredRenderer(scene, rays, sensor).render(Transform::Identity(), {}, 1);
  };
  const InfraredPair straight = rendered({});
  const InfraredPair off = rendered(options);
  EXPECT_NE(off.left.projected, straight.left.projected);
  EXPECT_NE(off.right.projected, straight.right.projected);
  EXPECT_EQ(rendered(options).left.projected, off.left.projected);
}

}  // namespace
}  // namespace rva
