// Debris by hand and at random, through the scene files that ask for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scene/scene_text.hpp"

namespace rva {
namespace {

using test::debris_names;
using test::extent_of;
using test::named;
using test::parsed;
using testing::ElementsAre;

bool same_objects(const Scene& one, const Scene& other) {
  return std::equal(one.objects.begin(), one.objects.end(), other.objects.begin(), other.objects.end(),
                    [](const SceneObject& a, const SceneObject& b) {
                      return a.name == b.name && a.world_from_object.matrix() == b.world_from_object.matrix();
                    });
}

TEST(DebrisSection, DropsDebrisAtTheStatedPosition) {
  const Scene scene = parsed(test::bay_head + R"(
debris:
  - { kind: screwdriver, on: [0.1, 0.47], turn_deg: 0 }
  - { kind: key, name: lost-key, on: [-0.2, 0.47], turn_deg: 90 }
  - { kind: collar-0.53, on: [0, 0.562] }
  - { kind: nut-m6, at_m: [0, 0.64, 0.2], turn_deg: [90, 0, 0] }
)");
  EXPECT_THAT(debris_names(scene), ElementsAre("screwdriver", "lost-key", "collar-0.53", "nut-m6"));
  EXPECT_EQ(named(scene, "lost-key").kind, "key");
  const Eigen::AlignedBox3d screwdriver = extent_of(scene, "screwdriver");
  EXPECT_NEAR(screwdriver.min().z(), 0.0, 1e-5) << "on the skin";
  EXPECT_GT(screwdriver.sizes().x(), 0.2) << "along x";
  EXPECT_GT(screwdriver.max().x() - 0.1, 0.1 - screwdriver.min().x()) << "its light tip points to +x";
  EXPECT_GT(extent_of(scene, "lost-key").sizes().y(), 0.05) << "along y";
  EXPECT_NEAR(extent_of(scene, "collar-0.53").min().z(), 0.038, 1e-5) << "on a stringer";
  EXPECT_NEAR(extent_of(scene, "nut-m6").sizes().y(), 0.0052, 1e-5) << "on edge, in the air";
  EXPECT_NEAR(extent_of(scene, "nut-m6").center().z(), 0.2, 1e-5);
}

TEST(DebrisSection, FromHeightAndRestingChooseWhereAndHowItLies) {
  const Scene scene = parsed(test::bay_head + R"(
debris:
  - { kind: washer-m6, on: [-0.1, 0.566], from_m: 0.02 }
  - { kind: washer-m6, on: [0.1, 0.562] }
  - { kind: nut-m6, on: [0, 0.47] }
  - { kind: nut-m6, on: [0.1, 0.47], resting: 2 }
)");
  EXPECT_NEAR(extent_of(scene, "washer-m6-1").min().z(), 0.0, 1e-5) << "below the flange";
  EXPECT_NEAR(extent_of(scene, "washer-m6-2").min().z(), 0.038, 1e-5) << "on it";
  EXPECT_NEAR(extent_of(scene, "nut-m6-1").sizes().z(), 0.0052, 1e-5);
  EXPECT_NEAR(extent_of(scene, "nut-m6-2").sizes().z(), 0.010, 1e-5);
}

TEST(DebrisSection, LaterDebrisLiesOnEarlier) {
  const Scene scene = parsed(test::bay_head + R"(
debris:
  - { kind: tape-roll, on: [0, 0.47] }
  - { kind: wrench, on: [0, 0.47] }
)");
  EXPECT_NEAR(extent_of(scene, "wrench").min().z(), 0.025, 1e-4);
}

TEST(DebrisSection, NumbersWhatIsThereMoreThanOnceAroundTakenNames) {
  const Scene scene = parsed(test::bay_head + R"(
debris:
  - { kind: rivet, at_m: [0, 0.5, 0.1] }
  - { kind: key, name: rivet-1, at_m: [0, 0.6, 0.1] }
  - { kind: rivet, at_m: [0, 0.7, 0.1] }
)");
  EXPECT_THAT(debris_names(scene), ElementsAre("rivet-2", "rivet-1", "rivet-3"));
}

const std::string scattered =
    test::bay_head +
    "debris:\n  - { random: 6, kinds: [rivet, rag, key], seed: 7, within_m: [[-0.3, 0.3], [0.3, 1]] }\n";

TEST(RandomDebris, IsTheSameForTheSameSeed) {
  EXPECT_TRUE(same_objects(parsed(scattered), parsed(scattered)));
  EXPECT_TRUE(same_objects(parsed(scattered), parsed(scattered, test::with_seed(7))));
  EXPECT_FALSE(same_objects(parsed(scattered), parsed(scattered, test::with_seed(8))));
}

TEST(RandomDebris, DoesNotDependOnTheRobot) {
  EXPECT_TRUE(same_objects(parsed(scattered), parsed(scattered, test::with_robot_at({0.1, 0.1, 0}))));
}

TEST(RandomDebris, LiesApartInsideItsBounds) {
  const Scene scene = parsed(scattered);
  std::vector<const SceneObject*> debris;
  for (const SceneObject& object : scene.objects) {
    if (object.role == Role::debris) debris.push_back(&object);
  }
  ASSERT_EQ(debris.size(), 6U);
  const Eigen::AlignedBox3d within(Eigen::Vector3d(-0.3, 0.3, 0), Eigen::Vector3d(0.3, 1, 0.36));
  for (std::size_t i = 0; i < debris.size(); ++i) {
    EXPECT_TRUE(within.contains(debris[i]->world_from_object.translation())) << debris[i]->name;
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_TRUE(bounds(world_mesh(*debris[i])).intersection(bounds(world_mesh(*debris[k]))).isEmpty());
    }
  }
}

TEST(RandomDebris, TwoSetsOfOneSeedDiffer) {
  const Scene scene = parsed(test::bay_head + R"(
debris:
  - { random: 1, kinds: [key], seed: 3 }
  - { random: 1, kinds: [key], seed: 3 }
)");
  EXPECT_GT((named(scene, "key-1").world_from_object.translation() -
             named(scene, "key-2").world_from_object.translation())
                .norm(),
            0.02);
}

TEST(PlannedParts, AreWorkThatTheBayBeforeLacks) {
  const std::string text = test::bay_head + "work: { parts: [{ kind: collar-0.36, on: [0.1, 0.562] }] }\n";
  const Scene after = test::parsed(text);
  EXPECT_EQ(test::named(after, "collar-0.36").role, Role::work);
  EXPECT_TRUE(test::debris_names(after).empty());
  const Scene before = test::parsed(text, test::without_debris());
  EXPECT_EQ(before.objects.size() + 1, after.objects.size());
}

}  // namespace
}  // namespace rva
