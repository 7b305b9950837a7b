#include "scene/file/scene_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/file.hpp"
#include "scene/camera_stand.hpp"
#include "scene/ray_caster.hpp"
#include "tests/scene/scene_text.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using test::debris_names;
using test::extent_of;
using test::named;
using test::parsed;
using testing::ElementsAre;
using testing::IsEmpty;

// A tetrahedron of 10 units that faces inward.
constexpr const char* inward_obj =
    "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

TEST(SceneFile, NeedsFormatAndVersionOnly) {
  const Scene scene = parsed(test::scene_head);
  EXPECT_EQ(scene.name, "scene");
  EXPECT_THAT(scene.objects, IsEmpty());
  EXPECT_TRUE(scene.bay.isEmpty());
}

TEST(SceneFile, AnEmptyWingHasTheThesisSizes) {
  const Scene scene = parsed(test::bay_head);
  EXPECT_TRUE(scene.bay.sizes().isApprox(Eigen::Vector3d(0.75, 1.10, 0.36)));
  EXPECT_EQ(named(scene, "rib-left").parts[0].material.name, "green-primer");
}

TEST(SceneFile, ReadsTheWing) {
  const Scene scene = parsed(test::scene_head + R"(
wing:
  span_m: 0.8
  chord_m: 1.2
  height_m: 0.4
  back_wall_m: 4
  skin: { thickness_mm: 4, upper: true, material: bare-aluminium }
  stringers: { profile: hat, count: 3, height_mm: 30, flange_mm: 20, thickness_mm: 2, material: steel }
  ribs: { thickness_mm: 5, holes: 1, hole_diameter_mm: 100, material: white-paint }
  spars: { thickness_mm: 8, flange_mm: 30, rear_height_mm: 400, material: matt-grey }
  access_hole: { width_mm: 400, height_mm: 200 }
robot: { at_m: [0, 0.1, 0] }
)");
  EXPECT_TRUE(scene.bay.sizes().isApprox(Eigen::Vector3d(0.8, 1.2, 0.4)));
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-6; };
  EXPECT_PRED2(near, extent_of(scene, "back-wall").min().y(), 4.0);
  EXPECT_PRED2(near, extent_of(scene, "skin-lower").min().z(), -0.004);
  EXPECT_PRED2(near, extent_of(scene, "skin-upper").max().z(), 0.404);
  EXPECT_PRED2(near, extent_of(scene, "stringer-3").max().z(), 0.030);
  EXPECT_GT(extent_of(scene, "stringer-3").sizes().y(), 0.060) << "a hat";
  EXPECT_PRED2(near, extent_of(scene, "rib-right").max().x(), 0.405);
  EXPECT_PRED2(near, extent_of(scene, "spar-near").min().y(), -0.008);
  EXPECT_PRED2(near, extent_of(scene, "spar-far").max().z(), 0.400);
  EXPECT_EQ(named(scene, "skin-upper").parts[0].material.name, "bare-aluminium");
  EXPECT_EQ(named(scene, "stringer-1").parts[0].material.name, "steel");
  EXPECT_EQ(named(scene, "rib-left").parts[0].material.name, "white-paint");
  EXPECT_EQ(named(scene, "spar-far").parts[0].material.name, "matt-grey");

  const RayCaster caster(scene);
  const auto is_open = [&](float x, float z) { return !caster.cast({{x, 0.1F, z}, {0, -1, 0}}); };
  EXPECT_TRUE(is_open(0.19F, 0.2F));
  EXPECT_FALSE(is_open(0.21F, 0.2F));
  EXPECT_TRUE(is_open(0, 0.29F));
  EXPECT_FALSE(is_open(0, 0.31F));
}

TEST(SceneFile, ReadsSolids) {
  const Scene scene = parsed(test::scene_head + R"(
solids:
  - { name: wall, shape: box, size_mm: [300, 10, 200], at_m: [0, 1, 0.1], material: matt-grey }
  - { name: pipe, shape: cylinder, diameter_mm: 20, length_mm: 100, at_m: [1, 1, 0], turn_deg: [0, 90, 0], material: steel }
  - { name: floor, shape: plane, size_mm: [500, 600], at_m: [0, 0, -1], material: concrete, debris: true }
)");
  ASSERT_EQ(scene.objects.size(), 3U);
  EXPECT_TRUE(extent_of(scene, "wall").min().isApprox(Eigen::Vector3d(-0.15, 0.995, 0.0), 1e-6));
  EXPECT_TRUE(extent_of(scene, "wall").max().isApprox(Eigen::Vector3d(0.15, 1.005, 0.2), 1e-6));
  EXPECT_TRUE(extent_of(scene, "pipe").sizes().isApprox(Eigen::Vector3d(0.1, 0.02, 0.02), 0.01));
  EXPECT_NEAR(extent_of(scene, "floor").max().z(), -1.0, 1e-6);
  EXPECT_EQ(scene.objects[1].kind, "cylinder");
  EXPECT_EQ(scene.objects[1].parts[0].material.name, "steel");
  EXPECT_EQ(scene.objects[1].role, Role::structure);
  EXPECT_EQ(scene.objects[2].role, Role::debris);
}

TEST(SceneFile, ReadsMeshesBesideIt) {
  const test::TemporaryFolder folder;
  write_file(folder / "wedge.obj", inward_obj);
  write_file(folder / "scene.yaml", test::scene_head + R"(
meshes:
  - { name: wedge, file: wedge.obj, unit: mm, at_m: [1, 0, 0], turn_deg: [0, 0, 90], material: steel }
)");
  const Scene scene = load_scene(folder / "scene.yaml");
  const TriangleMesh& mesh = named(scene, "wedge").parts[0].mesh;
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume_m3(mesh), 1e-6 / 6, 1e-9) << "turned outward";
  EXPECT_TRUE(extent_of(scene, "wedge").min().isApprox(Eigen::Vector3d(0.99, 0, 0), 1e-6));
}

TEST(SceneFile, ReadsLightAndRobot) {
  const Scene scene = parsed(test::scene_head + R"(
light: { ambient: 0.5, visible: 0.25, lamps: [{ at_m: [1, 2, 3], strength: 0.1 }, { at_m: [0, 0, 1] }] }
robot: { base: b7, at_m: [0.1, 0.2, 0.3], heading_deg: 10, pan_deg: -5, tilt_deg: -30 }
)");
  EXPECT_EQ(scene.lighting.ambient, 0.5);
  EXPECT_EQ(scene.lighting.visible, 0.25);
  ASSERT_EQ(scene.lighting.lamps.size(), 2U);
  EXPECT_EQ(scene.lighting.lamps[0].position_m, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(scene.lighting.lamps[0].strength, 0.1);
  EXPECT_EQ(scene.lighting.lamps[1].strength, 1.0);
  EXPECT_EQ(scene.stand.base, "b7");
  EXPECT_EQ(scene.stand.position_m, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(scene.stand.heading_deg, 10);
  EXPECT_EQ(scene.stand.pan_deg, -5);
  EXPECT_EQ(scene.stand.tilt_deg, -30);
}

TEST(CameraStand, HeadingTurnsTheFootToTheLeft) {
  CameraStand turned;
  turned.position_m = {1, 2, 0};
  turned.heading_deg = 90;
  turned.tilt_deg = 0;
  EXPECT_TRUE((world_from_foot(turned) * Eigen::Vector3d(0, 1, 0)).isApprox(Eigen::Vector3d(0, 2, 0)));
  const Eigen::Vector3d ahead = world_from_camera(turned).linear() * Eigen::Vector3d::UnitZ();
  EXPECT_TRUE(ahead.isApprox(Eigen::Vector3d(-1, 0, 0)));
}

TEST(SceneOverrides, MoveTheRobot) {
  SceneOverrides overrides = test::with_robot_at({0.1, 0.2, 0});
  overrides.pan_deg = 7;
  overrides.tilt_deg = -31;
  const Scene scene = parsed(test::bay_head, overrides);
  EXPECT_EQ(scene.stand.position_m, Eigen::Vector3d(0.1, 0.2, 0));
  EXPECT_EQ(scene.stand.pan_deg, 7);
  EXPECT_EQ(scene.stand.tilt_deg, -31);
}

TEST(SceneOverrides, TakeDebrisAwayOrFromAnotherFile) {
  const std::string cluttered = test::bay_head + R"(
solids: [{ name: block, shape: box, size_mm: [10, 10, 10], at_m: [0, 0.64, 0.005], material: steel, debris: true }]
debris: [{ kind: key, on: [0, 0.47] }]
)";
  EXPECT_THAT(debris_names(parsed(cluttered)), ElementsAre("block", "key"));
  EXPECT_THAT(debris_names(parsed(cluttered, test::without_debris())), IsEmpty());

  const test::TemporaryFolder folder;
  write_file(folder / "other.yaml", test::scene_head + "debris: [{ kind: rivet, on: [0, 0.47] }]\n");
  EXPECT_THAT(debris_names(parsed(cluttered, test::with_debris_of(folder / "other.yaml"))),
              ElementsAre("block", "rivet"));
}

TEST(ShippedScenes, AllLoad) {
  int loaded = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RVA_DATA_DIR "/scenes")) {
    if (entry.path().extension() != ".yaml") continue;
    const Scene scene = load_scene(entry.path());
    std::set<std::string> names;
    for (const SceneObject& object : scene.objects) {
      EXPECT_TRUE(names.insert(object.name).second) << object.name;
    }
    ++loaded;
  }
  EXPECT_GE(loaded, 8);
}

}  // namespace
}  // namespace rva
