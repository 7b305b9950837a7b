#include "scene/wing/fittings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "scene/wing/wing_bay.hpp"
#include "tests/scene/scene_text.hpp"

namespace rva {
namespace {

using test::named;
using test::parsed;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

std::vector<std::string> names_of(const std::vector<SceneObject>& objects) {
  std::vector<std::string> names;
  for (const SceneObject& object : objects) names.push_back(object.name);
  return names;
}

std::vector<std::string> work_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneObject& object : scene.objects) {
    if (object.role == Role::work) names.push_back(object.name);
  }
  return names;
}

WingBay bay_of(StringerProfile profile, std::uint64_t seed) {
  WingBay bay;
  bay.stringers.profile = profile;
  bay.fittings = {.brackets = 2, .hoses = 1, .cables = 2, .sealant = 2, .collars = 1, .seed = seed};
  return bay;
}

TEST(Fittings, AreClosedSolidsWithinTheBay) {
  constexpr double through_a_face_m = 0.03;  // beads lie half in the skin, hoses end in the ribs
  for (const StringerProfile profile : {StringerProfile::l, StringerProfile::z, StringerProfile::hat}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const WingBay bay = bay_of(profile, seed);
      Eigen::AlignedBox3d inside = inside_of(bay);
      inside.min().array() -= through_a_face_m;
      inside.max().array() += through_a_face_m;
      for (const SceneObject& object : make_fittings(bay, bay.fittings, Role::structure)) {
        for (const Part& part : object.parts) {
          EXPECT_TRUE(is_closed(part.mesh)) << object.name << ' ' << seed;
          EXPECT_GT(volume_m3(part.mesh), 0.0) << object.name << ' ' << seed;
        }
        EXPECT_TRUE(inside.contains(bounds(world_mesh(object)))) << object.name << ' ' << seed;
      }
    }
  }
}

TEST(Fittings, AreOfTheirSeedAndOneKindDoesNotChangeAnother) {
  const WingBay bay = bay_of(StringerProfile::z, 4);
  const auto all = make_fittings(bay, bay.fittings, Role::structure);
  EXPECT_THAT(names_of(all), ElementsAre("bracket-1", "bracket-2", "hose-1", "cable-1", "cable-2",
                                         "sealant-1", "sealant-2", "collars-1"));
  const auto cables = make_fittings(bay, {.cables = 2, .seed = 4}, Role::structure);
  EXPECT_EQ(cables[1].parts[0].mesh.vertices, all[4].parts[0].mesh.vertices);
  const auto others = make_fittings(bay, {.cables = 2, .seed = 5}, Role::structure);
  EXPECT_NE(cables[1].parts[0].mesh.vertices, others[1].parts[0].mesh.vertices);
}

TEST(Fittings, ABayWithoutThemIsAsItWas) {
  WingBay furnished = bay_of(StringerProfile::hat, 3);
  const std::size_t fittings = make_fittings(furnished, furnished.fittings, Role::structure).size();
  const std::vector<SceneObject> more = build_wing_bay(furnished);
  furnished.fittings = {};
  EXPECT_EQ(build_wing_bay(furnished).size() + fittings, more.size());
}

TEST(Work, InstallsAndHangsCablesAnew) {
  const WingBay bay = bay_of(StringerProfile::z, 4);
  Scene scene;
  scene.objects = build_wing_bay(bay);
  const SceneObject before = named(scene, "cable-1");
  do_work(bay, {.installed = {.brackets = 1, .collars = 1, .seed = 9}, .rehung = 1}, scene);
  EXPECT_THAT(work_names(scene), UnorderedElementsAre("rehung-cable-1", "new-bracket-1", "new-collars-1"));
  EXPECT_THAT(names_of(scene.objects), testing::Not(testing::Contains("cable-1")));
  const SceneObject& after = named(scene, "rehung-cable-1");
  EXPECT_EQ(after.parts[0].material.name, before.parts[0].material.name) << "the same cable";
  EXPECT_NE(after.parts[0].mesh.vertices, before.parts[0].mesh.vertices);
}

TEST(Work, OfASceneFileIsNotThereBefore) {
  const std::string text = test::scene_head +
                           "robot: { at_m: [0, 0.10, 0], tilt_deg: -20 }\n"
                           "wing: { fittings: { cables: 1, brackets: 1, seed: 3 }, dirt: 0.5 }\n"
                           "work: { rehung: 1, sealant: 1, seed: 2 }\n";
  const Scene after = parsed(text);
  EXPECT_THAT(work_names(after), UnorderedElementsAre("rehung-cable-1", "new-sealant-1"));
  EXPECT_EQ(named(after, "skin-lower").parts[0].material.dirt, 0.5);
  const Scene before = parsed(text, test::without_debris());
  EXPECT_THAT(work_names(before), ElementsAre());
  EXPECT_THAT(names_of(before.objects), testing::Contains("cable-1"));
}

}  // namespace
}  // namespace rva
