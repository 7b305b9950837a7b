#include "evaluate/random_wing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "sim/scene/camera_stand.hpp"
#include "sim/scene/drop_zone.hpp"
#include "sim/scene/ray_caster.hpp"

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
