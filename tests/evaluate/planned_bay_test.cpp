#include "evaluate/planned_bay.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "plan/plan_areas.hpp"
#include "scene/camera_stand.hpp"

namespace rva {
namespace {

constexpr std::uint64_t first_seed = 1;
constexpr std::uint64_t seeds = 6;

std::vector<const SceneObject*> of_role(const Scene& scene, Role role) {
  std::vector<const SceneObject*> objects;
  for (const SceneObject& object : scene.objects) {
    if (object.role == role) objects.push_back(&object);
  }
  return objects;
}

int parts_of(const Plan& plan) {
  int parts = 0;
  for (const PlannedItem& item : plan.items) parts += item.count;
  return parts;
}

// The place in the world frame.
Eigen::Vector3d world_of(const PlanPoint& point, const Scene& scene) {
  return world_from_camera(scene.stand) * (point.depth_m * point.at.homogeneous());
}

bool is_at(const SceneObject& object, const Eigen::Vector3d& world) {
  constexpr double near_m = 1e-6;
  return (bounds(world_mesh(object)).center() - world).norm() < near_m;
}

TEST(PlannedBay, HasAllPlannedPartsButOneAtTheirPlaces) {
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    const PlannedBay bay = random_planned_bay(seed);
    const auto installed = of_role(bay.after, Role::work);
    EXPECT_GE(parts_of(bay.plan), 20) << seed;
    EXPECT_LE(parts_of(bay.plan), 60) << seed;
    EXPECT_EQ(static_cast<int>(installed.size()), parts_of(bay.plan) - 1) << seed;
    for (const PlannedItem& item : bay.plan.items) {
      for (std::size_t k = 0; k < item.places.size(); ++k) {
        const bool is_there = std::ranges::any_of(installed, [&](const SceneObject* object) {
          return is_at(*object, world_of(item.places[k], bay.after));
        });
        const bool is_missing = item.name == bay.item && static_cast<int>(k) + 1 == bay.place;
        EXPECT_EQ(is_there, !is_missing) << seed << " " << item.name << " " << k;
      }
    }
  }
}

TEST(PlannedBay, HasOneLostObjectAfterTheWorkOnly) {
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    const PlannedBay bay = random_planned_bay(seed);
    EXPECT_EQ(of_role(bay.after, Role::debris).size(), 1U) << seed;
    EXPECT_TRUE(of_role(bay.before, Role::debris).empty()) << seed;
    EXPECT_TRUE(of_role(bay.before, Role::work).empty()) << seed;
  }
}

TEST(PlannedBay, HasAPlanThatDoesNotOverlapItself) {
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    const std::vector<PlannedItem> items = random_planned_bay(seed).plan.items;
    for (std::size_t a = 0; a < items.size(); ++a) {
      EXPECT_TRUE(fault_of(items[a].areas.front()).empty()) << seed;
      for (std::size_t b = a + 1; b < items.size(); ++b) EXPECT_FALSE(overlap(items[a], items[b])) << seed;
    }
  }
}

TEST(PlannedBay, IsTheSameForTheSameSeed) {
  const PlannedBay one = random_planned_bay(3);
  const PlannedBay other = random_planned_bay(3);
  EXPECT_EQ(one.plan, other.plan);
  EXPECT_EQ(one.place, other.place);
  EXPECT_NE(one.plan, random_planned_bay(4).plan);
}

TEST(PlannedBay, WithoutPlacesTheNumbersRemain) {
  const Plan plan = random_planned_bay(2).plan;
  const Plan counted = without_places(plan);
  EXPECT_EQ(parts_of(counted), parts_of(plan));
  for (const PlannedItem& item : counted.items) {
    EXPECT_TRUE(item.places.empty());
    EXPECT_FALSE(item.areas.empty());
  }
}

}  // namespace
}  // namespace rva
