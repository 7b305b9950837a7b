#include <gtest/gtest.h>

#include <cmath>

#include "sim/sensor/infrared_renderer.hpp"
#include "tests/sim/small_scenes.hpp"

namespace rva {
namespace {

constexpr int middle_row = 240;

/// Light without dots, blur or bounces: what is left can be worked out by hand.
StereoSensorOptions even_light() {
  StereoSensorOptions options;
  options.dots = 0;
  options.lens_blur_px = 0.0;
  options.bounce = 0.0;
  return options;
}

ImagerLight left_view(const Scene& scene, const StereoSensorOptions& options = even_light()) {
  const RayCaster rays(scene);
  return InfraredRenderer(scene, rays, options).render(Transform::Identity(), {}, 1).left;
}

Scene scene_of(const std::vector<SceneObject>& objects) {
  Scene scene;
  scene.objects = objects;
  return scene;
}

/// Column of the left imager that sees a point on a surface.
int column_of(double x_m, double z_m) { return static_cast<int>(std::lround(423.5 + 425.0 * x_m / z_m)); }

double greatest(const Image<float>& image) {
  return static_cast<double>(*std::max_element(image.pixels().begin(), image.pixels().end()));
}

TEST(InfraredLight, AWhiteWallAtOneMetreGivesOneWithinTheField) {
  const double projector_x_m = stereo_rig({}).projector_m.x();
  const ImagerLight view = left_view(scene_of({test::wall_at(1.0)}));
  EXPECT_NEAR(view.projected(column_of(projector_x_m, 1.0), middle_row), 1.0F, 1e-3F);
  EXPECT_EQ(greatest(view.steady), 0.0);
  const int left_end = column_of(projector_x_m - DotPattern::half_width, 1.0);
  EXPECT_EQ(view.projected(left_end - 3, middle_row), 0.0F);
  EXPECT_GT(view.projected(left_end + 3, middle_row), 0.2F);
}

TEST(InfraredLight, FallsWithTheSquareOfTheDistance) {
  const StereoRig rig = stereo_rig({});
  for (const double z_m : {0.4, 2.0}) {
    const ImagerLight view = left_view(scene_of({test::wall_at(z_m)}));
    for (const auto& [u, v] : {std::pair{150, 100}, {424, 240}, {700, 400}}) {
      const Eigen::Vector3d from_projector = rig.imager.deproject({u, v}, z_m) - rig.projector_m;
      const double distance_m = from_projector.norm();
      // On a wall, the cosine of the light's angle is z over the distance.
      const double expected = z_m / std::pow(distance_m, 3);
      EXPECT_NEAR(view.projected(u, v), expected, 1e-3 * expected) << z_m << ": " << u << " " << v;
    }
  }
}

TEST(InfraredLight, IsProportionalToTheAlbedo) {
  const ImagerLight white = left_view(scene_of({test::wall_at(1.0)}));
  const ImagerLight grey = left_view(scene_of({test::wall_at(1.0, test::with_albedo(0.25))}));
  for (const int u : {200, 424, 600})
    EXPECT_NEAR(grey.projected(u, 99), 0.25F * white.projected(u, 99), 1e-5F);
}

class Post : public testing::Test {
 protected:
  // 40 mm wide, half way to the wall. Light from the projector passes its left edge to -68.5 mm on the wall;
  // the imager sees the wall as far as -40 mm.
  static Scene scene() {
    return scene_of({test::wall_at(1.0), test::box_at("post", {0, 0, 0.505}, {0.04, 4, 0.01})});
  }
  const int shadow_ = column_of(-0.055, 1.0);
  const int beside_ = column_of(-0.080, 1.0);
  const int post_ = column_of(0.0, 0.5);
};

TEST_F(Post, ShadesTheProjector) {
  StereoSensorOptions options = even_light();
  options.bounce = 0.05;
  const ImagerLight view = left_view(scene(), options);
  EXPECT_EQ(view.projected(shadow_, middle_row), 0.0F);
  EXPECT_GT(view.projected(beside_, middle_row), 0.9F);
  EXPECT_NEAR(view.projected(post_, middle_row), 4.0F, 0.05F);
  EXPECT_GT(view.steady(shadow_, middle_row), 0.0F);
  EXPECT_EQ(view.steady(shadow_, middle_row), view.steady(beside_, middle_row));
}

TEST_F(Post, TheShadowIsWhereGeometryPutsIt) {
  const ImagerLight view = left_view(scene());
  EXPECT_GT(view.projected(column_of(-0.0685, 1.0) - 2, middle_row), 0.9F);
  EXPECT_EQ(view.projected(column_of(-0.0685, 1.0) + 2, middle_row), 0.0F);
  EXPECT_EQ(view.projected(column_of(-0.0400, 1.0) - 2, middle_row), 0.0F);
  EXPECT_GT(view.projected(column_of(-0.0400, 1.0) + 2, middle_row), 3.5F);
}

TEST_F(Post, AmbientLightIsSteadyAndEverywhere) {
  Scene scene = this->scene();
  const ImagerLight dark = left_view(scene);
  scene.lighting.ambient = 0.3;
  const ImagerLight bright = left_view(scene);
  EXPECT_EQ(bright.projected, dark.projected);
  EXPECT_EQ(greatest(dark.steady), 0.0);
  EXPECT_GT(bright.steady(shadow_, middle_row), 0.0F);
  scene.lighting.ambient = 0.6;
  EXPECT_FLOAT_EQ(left_view(scene).steady(shadow_, middle_row), 2.0F * bright.steady(shadow_, middle_row));
}

TEST_F(Post, ShadesLampsToo) {
  Scene scene = this->scene();
  const ImagerLight dark = left_view(scene);
  // At the eye, so that the post hides its own shadow; then to its right, which shades the wall left of it.
  scene.lighting.lamps = {{Eigen::Vector3d::Zero(), 2.0}};
  const ImagerLight from_eye = left_view(scene);
  EXPECT_EQ(from_eye.projected, dark.projected);
  EXPECT_NEAR(from_eye.steady(column_of(0.0, 0.5), middle_row), 8.0F, 0.01F);
  EXPECT_GT(from_eye.steady(shadow_, middle_row), 1.9F);
  scene.lighting.lamps = {{Eigen::Vector3d(0.0285, 0, 0), 1.0}};
  const ImagerLight from_projector = left_view(scene);
  EXPECT_EQ(from_projector.steady(shadow_, middle_row), 0.0F);
  EXPECT_FLOAT_EQ(from_projector.steady(beside_, middle_row), dark.projected(beside_, middle_row));
}

TEST(InfraredLight, NothingThereIsDark) {
  Scene scene;
  scene.lighting.ambient = 1.0;
  const ImagerLight view = left_view(scene);
  EXPECT_EQ(greatest(view.steady), 0.0);
  EXPECT_EQ(greatest(view.projected), 0.0);
}

}  // namespace
}  // namespace rva
