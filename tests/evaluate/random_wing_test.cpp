#include "evaluate/random_wing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/error.hpp"
#include "evaluate/moved_wing.hpp"
#include "scene/camera_stand.hpp"
#include "scene/drop_zone.hpp"
#include "scene/ray_caster.hpp"

namespace rva {
namespace {

TEST(RandomWing, IsOfItsSeed) {
  const Scene scene = random_wing(3);
  const Scene same = random_wing(3);
  const Scene other = random_wing(4);
  ASSERT_EQ(scene.objects.size(), same.objects.size());
  EXPECT_EQ(scene.objects[0].parts[0].mesh.vertices, same.objects[0].parts[0].mesh.vertices);
  EXPECT_EQ(scene.stand.tilt_deg, same.stand.tilt_deg);
  EXPECT_NE(scene.stand.tilt_deg, other.stand.tilt_deg);
}

TEST(RandomWing, LeavesTheCameraFree) {
  std::set<std::string> skins;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Scene scene = random_wing(seed);
    const RayCaster rays(scene);
    EXPECT_FALSE(rays.solid_around(world_from_camera(scene.stand).translation())) << seed;
    const auto skin = std::ranges::find(scene.objects, "skin-lower", &SceneObject::name);
    ASSERT_NE(skin, scene.objects.end());
    skins.insert(std::string(skin->parts[0].material.name));
  }
  EXPECT_GE(skins.size(), 3) << "of five coats";
}

TEST(RandomWing, IsTheSameSheetMetalWithAnyContent) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Scene plain = random_wing(seed);
    const Scene hard = random_wing(seed, bay_features({"brackets", "hoses", "cables", "sealant", "dirt"}));
    EXPECT_GT(hard.objects.size(), plain.objects.size());
    EXPECT_EQ(hard.stand.tilt_deg, plain.stand.tilt_deg);
    EXPECT_EQ(hard.lighting.ambient, plain.lighting.ambient);
    const auto skin = [](const Scene& scene) -> const SceneObject& {
      return *std::ranges::find(scene.objects, "skin-lower", &SceneObject::name);
    };
    EXPECT_EQ(skin(hard).parts[0].material.name, skin(plain).parts[0].material.name);
    EXPECT_GT(skin(hard).parts[0].material.dirt, 0.0);
    EXPECT_EQ(skin(plain).parts[0].material.dirt, 0.0);
    const RayCaster rays(hard);
    EXPECT_FALSE(rays.solid_around(world_from_camera(hard.stand).translation())) << seed;
  }
}

TEST(RandomWing, WorkIsThereOnlyAfterwards) {
  int rehung = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const MovedWing wing = random_moved_wing(seed, CameraReturn::rest, bay_features({"cables", "work"}));
    const auto has_work = [](const Scene& scene) {
      return std::ranges::any_of(scene.objects,
                                 [](const SceneObject& object) { return object.role == Role::work; });
    };
    EXPECT_FALSE(has_work(wing.before));
    EXPECT_TRUE(has_work(wing.after)) << seed;
    const auto found = std::ranges::find(wing.after.objects, "rehung-cable-1", &SceneObject::name);
    rehung += found == wing.after.objects.end() ? 0 : 1;
  }
  EXPECT_GT(rehung, 2);
  EXPECT_LT(rehung, 18);
}

TEST(BayFeatures, AreNamedOneByOneOrAllAtOnce) {
  EXPECT_EQ(bay_features({}), BayFeatures{});
  EXPECT_TRUE(bay_features({"dirt"}).dirt);
  EXPECT_FALSE(bay_features({"dirt"}).work);
  std::vector<std::string> every;
  for (const std::string_view name : bay_feature_names()) every.emplace_back(name);
  EXPECT_EQ(bay_features({"all"}), bay_features(every));
  EXPECT_THROW((void)bay_features({"dirt", "gold"}), UsageError);
}

TEST(RandomWing, DebrisLiesInItsBay) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Scene scene = random_wing(seed);
    const std::size_t structure = scene.objects.size();
    drop_debris(scene, seed);
    EXPECT_GT(scene.objects.size(), structure) << seed;
    for (std::size_t i = structure; i < scene.objects.size(); ++i) {
      EXPECT_EQ(scene.objects[i].role, Role::debris);
      EXPECT_TRUE(lies_inside(scene, scene.objects[i])) << seed << ' ' << scene.objects[i].kind;
    }
  }
}

}  // namespace
}  // namespace rva
