#include "scene/wing/wing_bay.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/ray_caster.hpp"

namespace rva {
namespace {

Scene scene_of(const WingBay& bay) {
  Scene scene;
  scene.objects = build_wing_bay(bay);
  return scene;
}

WingBay bay_with(StringerProfile profile) {
  WingBay bay;
  bay.stringers.profile = profile;
  return bay;
}

const SceneObject& named(const Scene& scene, const std::string& name) {
  return *std::find_if(scene.objects.begin(), scene.objects.end(),
                       [&](const SceneObject& object) { return object.name == name; });
}

Eigen::AlignedBox3d extent_of(const Scene& scene, const std::string& name) {
  return bounds(world_mesh(named(scene, name)));
}

// Name of what a ray meets first; empty for nothing.
std::string met(const Scene& scene, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) {
  const auto hit = RayCaster(scene).cast({origin, direction});
  return hit ? scene.objects[hit->object].name : "";
}

std::ptrdiff_t count_of(const Scene& scene, const std::string& kind) {
  return std::count_if(scene.objects.begin(), scene.objects.end(),
                       [&](const SceneObject& object) { return object.kind == kind; });
}

class EveryProfile : public testing::TestWithParam<StringerProfile> {};
INSTANTIATE_TEST_SUITE_P(WingBay, EveryProfile,
                         testing::Values(StringerProfile::l, StringerProfile::z, StringerProfile::hat));

TEST_P(EveryProfile, IsMadeOfClosedSolidsThatFaceOutward) {
  for (const SceneObject& object : build_wing_bay(bay_with(GetParam()))) {
    ASSERT_EQ(object.parts.size(), 1U);
    EXPECT_TRUE(is_closed(object.parts[0].mesh)) << object.name;
    EXPECT_GT(volume_m3(object.parts[0].mesh), 0.0) << object.name;
  }
}

TEST_P(EveryProfile, StringersAreAsHighAsStated) {
  const Scene scene = scene_of(bay_with(GetParam()));
  const Eigen::AlignedBox3d extent = extent_of(scene, "stringer-1");
  EXPECT_NEAR(extent.min().z(), 0.0, 1e-6);
  EXPECT_NEAR(extent.max().z(), 0.038, 1e-6);
  EXPECT_NEAR(extent.sizes().x(), 0.75, 1e-6);
}

TEST(WingBay, SurroundsItsInside) {
  const WingBay bay;
  const Scene scene = scene_of(bay);
  const Eigen::AlignedBox3d inside = inside_of(bay);
  EXPECT_TRUE(inside.min().isApprox(Eigen::Vector3d(-0.375, 0, 0)));
  EXPECT_TRUE(inside.max().isApprox(Eigen::Vector3d(0.375, 1.1, 0.36)));
  const double rounding = 1e-6;
  EXPECT_NEAR(extent_of(scene, "skin-lower").max().z(), 0.0, rounding);
  EXPECT_NEAR(extent_of(scene, "rib-left").min().x(), -0.378, rounding);
  EXPECT_NEAR(extent_of(scene, "rib-right").max().x(), 0.378, rounding);
  EXPECT_NEAR(extent_of(scene, "spar-near").min().y(), -0.006, rounding);
  EXPECT_NEAR(extent_of(scene, "spar-far").max().y(), 1.106, rounding);
  EXPECT_NEAR(extent_of(scene, "spar-far").max().z(), 0.26, rounding);
}

TEST(WingBay, StringersAreSpreadAlongTheChord) {
  WingBay bay;
  bay.stringers.count = 3;
  const Scene scene = scene_of(bay);
  EXPECT_EQ(count_of(scene, "stringer"), 3);
  EXPECT_NEAR(named(scene, "stringer-1").world_from_object.translation().y(), 1.1 / 4, 1e-12);
  EXPECT_NEAR(named(scene, "stringer-3").world_from_object.translation().y(), 1.1 * 3 / 4, 1e-12);
  bay.stringers.count = 0;
  EXPECT_EQ(count_of(scene_of(bay), "stringer"), 0);
}

TEST(WingBay, AZStringerOverhangsAwayFromTheAccessHole) {
  const Scene scene = scene_of(WingBay{});
  const float web = 1.1F / 6;
  // Down onto the upper flange behind the web, and onto the foot before it.
  const RayCaster caster(scene);
  const auto height_at = [&](float y) {
    return 0.3F - caster.cast({{0.02F, y, 0.3F}, {0, 0, -1}})->distance;
  };
  EXPECT_NEAR(height_at(web + 0.015F), 0.038F, 1e-5F);
  EXPECT_NEAR(height_at(web - 0.005F), 0.0025F, 1e-5F);
  EXPECT_NEAR(height_at(web + 0.05F), 0.0F, 1e-5F);
}

TEST(WingBay, RaysPassThroughItsHoles) {
  const Scene scene = scene_of(WingBay{});
  const Eigen::Vector3f middle(0, 0.55F, 0.18F);
  EXPECT_EQ(met(scene, middle, {0, -1, 0}), "") << "the access hole";
  EXPECT_EQ(met(scene, middle, {1, 0, 0}), "") << "a lightening hole";
  EXPECT_EQ(met(scene, {0, 0.50F, 0.02F}, {0, -1, 0}), "stringer-2");
  EXPECT_EQ(met(scene, {0, 0.1F, 0.02F}, {0, -1, 0}), "spar-near");
  EXPECT_EQ(met(scene, {0, 0.37F, 0.18F}, {-1, 0, 0}), "rib-left") << "between two holes";
}

TEST(WingBay, HasNoHolesWhereNoneAreAskedFor) {
  WingBay bay;
  bay.ribs.holes = 0;
  bay.access_hole_width_mm = 0;
  const Scene scene = scene_of(bay);
  const Eigen::Vector3f middle(0, 0.55F, 0.18F);
  EXPECT_EQ(met(scene, middle, {0, -1, 0}), "spar-near");
  EXPECT_EQ(met(scene, middle, {1, 0, 0}), "rib-right");
}

TEST(WingBay, ShowsTheRoomAboveTheFarSpar) {
  const Scene scene = scene_of(WingBay{});
  EXPECT_EQ(met(scene, {0, 0.55F, 0.30F}, {0, 1, 0}), "back-wall");
  EXPECT_EQ(met(scene, {0, 0.55F, 0.20F}, {0, 1, 0}), "spar-far");
  EXPECT_EQ(met(scene, {0, 0.55F, 0.30F}, {0, 0, 1}), "") << "open on top";
  EXPECT_EQ(named(scene, "back-wall").role, Role::room);
}

TEST(WingBay, IsClosedByAnUpperSkin) {
  WingBay bay;
  bay.upper_skin = true;
  bay.back_wall_m = 0;
  const Scene scene = scene_of(bay);
  EXPECT_EQ(met(scene, {0, 0.55F, 0.30F}, {0, 0, 1}), "skin-upper");
  EXPECT_EQ(count_of(scene, "back-wall"), 0);
}

TEST(WingBay, HasRivetHeadsOnItsStringersFeet) {
  WingBay bay;
  bay.stringers.count = 1;
  const Scene scene = scene_of(bay);
  std::vector<Ray> rays;
  for (int x_mm = -300; x_mm < 300; ++x_mm)
    rays.push_back({{static_cast<float>(x_mm) * 1e-3F, 0.55F - 0.013F, 0.1F}, {0, 0, -1}});
  std::vector<Hit> hits(rays.size());
  RayCaster(scene).cast(rays, hits);
  const auto risen =
      std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.distance < 0.0973F; });
  // 5 mm of every 35.
  EXPECT_GT(risen, 600 * 3 / 35);
  EXPECT_LT(risen, 600 * 6 / 35);
}

}  // namespace
}  // namespace rva
