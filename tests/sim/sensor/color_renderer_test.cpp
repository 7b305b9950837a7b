#include "sim/sensor/color_renderer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/small_scenes.hpp"

namespace rva {
namespace {

Material painted(Rgb color) {
  Material material = test::white;
  material.color = color;
  return material;
}

ColorView rendered(const Scene& scene) {
  const RayCaster rays(scene);
  return render_color(scene, rays, stereo_rig({}), Transform::Identity(), 1);
}

Scene scene_of(const SceneObject& object) {
  Scene scene;
  scene.objects.push_back(object);
  return scene;
}

double linear(int value) { return std::pow(value / 255.0, 2.2); }

TEST(ColorRenderer, ChannelsAreTheMaterialsColour) {
  const ColorView view = rendered(scene_of(test::wall_at(1.0, painted({200, 120, 40}))));
  for (const auto& [u, v] : {std::pair{100, 100}, {424, 240}, {800, 470}}) {
    EXPECT_GT(view.red(u, v), 0.03F);
    EXPECT_NEAR(view.green(u, v) / view.red(u, v), linear(120) / linear(200), 1e-4);
    EXPECT_NEAR(view.blue(u, v) / view.red(u, v), linear(40) / linear(200), 1e-4);
  }
}

TEST(ColorRenderer, ItsImagerIsBesideTheDepthImager) {
  const ColorView view = rendered(scene_of(test::box_at("post", {0, 0, 1.05}, {0.1, 0.1, 0.1})));
  int first = 0;
  while (first < 847 && view.red(first, 240) == 0.0F) ++first;
  int last = 847;
  while (last > 0 && view.red(last, 240) == 0.0F) --last;
  // 15 mm to the left of the depth imager, the post is 15 mm to the right.
  EXPECT_NEAR((first + last) / 2.0, 423.5 + 617.0 * 0.015, 1.0);
  EXPECT_NEAR(last - first + 1, 617.0 * 0.1, 2.0);
}

TEST(ColorRenderer, AClosedWingIsDark) {
  Scene scene = scene_of(test::wall_at(1.0));
  const ColorView lit = rendered(scene);
  scene.lighting.visible = 0.5;
  EXPECT_FLOAT_EQ(rendered(scene).green(300, 200), 0.5F * lit.green(300, 200));
  scene.lighting.visible = 0.0;
  const ColorView dark = rendered(scene);
  EXPECT_EQ(*std::max_element(dark.green.pixels().begin(), dark.green.pixels().end()), 0.0F);
}

ColorView flat(float light) {
  const Image<float> even(64, 48, light);
  return {even, even, even};
}

TEST(ColorRenderer, TheLampBesideTheImagersLightsADarkWingByTheSquareOfTheDistance) {
  const auto brightness_at = [](double distance_m, double lamp) {
    Scene wing = scene_of(test::wall_at(distance_m, painted({255, 255, 255})));
    wing.lighting.visible = 0.0;
    const RayCaster rays(wing);
    return render_color(wing, rays, stereo_rig({}), Transform::Identity(), 1, lamp).green(424, 240);
  };
  EXPECT_EQ(brightness_at(1.0, 0.0), 0.0F);
  const float full = brightness_at(1.0, 1.0);
  EXPECT_GT(full, 0.05F);
  EXPECT_NEAR(brightness_at(1.0, 0.3) / full, 0.3, 1e-4);
  EXPECT_NEAR(brightness_at(2.0, 1.0) / full, 0.25, 0.01) << "the lamp is a few degrees off the axis";
}

TEST(ColorExposure, AppliesGamma) {
  for (const float light : {0.02F, 0.2F, 0.5F, 0.9F}) {
    const ColorImage image = expose_color(flat(light), 1);
    double sum = 0.0;
    for (const Rgb& pixel : image.pixels()) sum += pixel.g;
    const double expected = 255.0 * std::pow(static_cast<double>(light), 1.0 / 2.2);
    EXPECT_NEAR(sum / static_cast<double>(image.size()), expected, 1.5) << light;
  }
}

TEST(ColorExposure, IsClippedAtBothEnds) {
  const ColorImage bright = expose_color(flat(5.0F), 1);
  EXPECT_EQ(bright, ColorImage(64, 48, Rgb{255, 255, 255}));
  const ColorImage dark = expose_color(flat(0.0F), 1);
  for (const Rgb& pixel : dark.pixels()) ASSERT_LT(pixel.r, 40);
}

TEST(ColorExposure, NoiseIsOfTheSeed) {
  EXPECT_EQ(expose_color(flat(0.3F), 1), expose_color(flat(0.3F), 1));
  EXPECT_NE(expose_color(flat(0.3F), 1), expose_color(flat(0.3F), 2));
}

}  // namespace
}  // namespace rva
