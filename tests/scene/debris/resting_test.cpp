#include "scene/debris/resting.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/debris/debris_catalogue.hpp"
#include "scene/solids/convex_hull.hpp"
#include "scene/solids/shapes.hpp"

namespace rva {
namespace {

std::vector<Part> body(TriangleMesh mesh) { return {{std::move(mesh), find_material("steel")}}; }

SceneObject solid(const Eigen::Vector3d& size_m, const Eigen::Vector3d& center_m) {
  SceneObject object;
  object.parts = body(box(size_m));
  object.world_from_object.translation() = center_m;
  return object;
}

/// A table, 1 m by 1 m, its top at z = 0.
SceneObject table() { return solid({1, 1, 0.1}, {0, 0, -0.05}); }

Scene scene_of(std::vector<SceneObject> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  return scene;
}

double total_probability(const std::vector<RestingOrientation>& orientations) {
  double total = 0.0;
  for (const RestingOrientation& orientation : orientations) total += orientation.probability;
  return total;
}

double lowest_z_m(const std::vector<Part>& parts, const Transform& world_from_body) {
  SceneObject object;
  object.parts = parts;
  object.world_from_object = world_from_body;
  return bounds(world_mesh(object)).min().z();
}

TEST(RestingOrientations, BoxLiesOnItsSixFacesLargestMostOften) {
  const auto orientations = resting_orientations(body(box({0.010, 0.020, 0.040})));
  ASSERT_EQ(orientations.size(), 6U);
  EXPECT_NEAR(total_probability(orientations), 1.0, 1e-9);
  const std::array<double, 6> heights_m{0.005, 0.005, 0.010, 0.010, 0.020, 0.020};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(orientations[i].height_m, heights_m[i], 1e-6);
    EXPECT_EQ(orientations[i].support.size(), 4U);
  }
  EXPECT_NEAR(orientations[0].probability, orientations[1].probability, 1e-6);
  EXPECT_GT(orientations[1].probability, 2 * orientations[2].probability);
  EXPECT_GT(orientations[3].probability, 2 * orientations[4].probability);
}

TEST(RestingOrientations, CylinderLiesOnItsSide) {
  constexpr double radius_m = 0.005;
  double on_its_side = 0.0;
  for (const RestingOrientation& orientation : resting_orientations(body(cylinder(radius_m, 0.06, 24)))) {
    if (orientation.height_m < 1.01 * radius_m) on_its_side += orientation.probability;
  }
  EXPECT_GT(on_its_side, 0.95);
  EXPECT_LT(on_its_side, 1.0);
}

TEST(RestingOrientations, PutTheLowestPointOnTheFloorAndTheCentreOverTheSupport) {
  for (const DebrisKind& kind : debris_catalogue()) {
    const std::vector<Part> parts = make_debris(kind.name, 3);
    const auto orientations = resting_orientations(parts);
    ASSERT_FALSE(orientations.empty()) << kind.name;
    EXPECT_NEAR(total_probability(orientations), 1.0, 1e-9);
    for (const RestingOrientation& orientation : orientations) {
      Transform floor_from_body = Transform::Identity();
      floor_from_body.linear() = orientation.floor_from_body;
      EXPECT_NEAR(orientation.floor_from_body.determinant(), 1.0, 1e-9);
      EXPECT_NEAR(lowest_z_m(parts, floor_from_body), -orientation.height_m, 5e-5) << kind.name;
      EXPECT_GT(depth_inside(orientation.support, {0, 0}), 0.0) << kind.name;
    }
  }
}

TEST(RestingOrientations, OfNothingAreNone) { EXPECT_TRUE(resting_orientations({}).empty()); }

class PutDown : public testing::Test {
 protected:
  [[nodiscard]] std::optional<Transform> put_block(const Scene& scene, const Eigen::Vector3d& place_m) const {
    return put_down(RayCaster(scene), block_, orientations_.front(), 30.0, place_m);
  }

  std::vector<Part> block_ = body(box({0.010, 0.020, 0.040}));
  std::vector<RestingOrientation> orientations_ = resting_orientations(block_);
};

TEST_F(PutDown, TouchesATable) {
  const Eigen::Vector3d place_m(0.2, -0.1, 0.3);
  const std::optional<Transform> world_from_body = put_block(scene_of({table()}), place_m);
  ASSERT_TRUE(world_from_body);
  EXPECT_NEAR(lowest_z_m(block_, *world_from_body), 0.0, 1e-4);
  EXPECT_LT((world_from_body->translation().head<2>() - place_m.head<2>()).norm(), 1e-9);
  EXPECT_NEAR(world_from_body->translation().z(), 0.005, 1e-4);
}

TEST_F(PutDown, TurnsAboutTheVertical) {
  const Scene scene = scene_of({table()});
  const RayCaster surface(scene);
  const auto straight = put_down(surface, block_, orientations_[0], 0.0, {0, 0, 0.3});
  const auto turned = put_down(surface, block_, orientations_[0], 90.0, {0, 0, 0.3});
  ASSERT_TRUE(straight && turned);
  const Eigen::AngleAxisd quarter(std::acos(0.0), Eigen::Vector3d::UnitZ());
  EXPECT_TRUE((quarter * straight->linear()).isApprox(turned->linear(), 1e-9));
}

TEST_F(PutDown, NotBesideOrOverTheEdgeOfATable) {
  EXPECT_FALSE(put_block(scene_of({table()}), {2.0, 0, 0.3}));
  EXPECT_FALSE(put_block(scene_of({table()}), {0.499, 0, 0.3}));
}

TEST_F(PutDown, NotOnAStepNorAgainstAWall) {
  const SceneObject step = solid({0.2, 0.2, 0.004}, {0.1, 0, 0.002});
  const Scene scene = scene_of({table(), step});
  EXPECT_FALSE(put_block(scene, {-0.004, 0, 0.3}));
  EXPECT_TRUE(put_block(scene, {0.1, 0, 0.3}));
  EXPECT_FALSE(put_block(scene_of({table(), solid({0.003, 1, 0.5}, {0, 0, 0.25})}), {0.008, 0, 0.3}));
}

// A body whose centre is over the step stays, even where its end is in the air.
TEST_F(PutDown, OnAStepThatCarriesItsCentre) {
  const Scene scene = scene_of({table(), solid({0.2, 0.2, 0.004}, {0.1, 0, 0.002})});
  const std::optional<Transform> world_from_body = put_block(scene, {0.004, 0, 0.3});
  ASSERT_TRUE(world_from_body);
  EXPECT_NEAR(lowest_z_m(block_, *world_from_body), 0.004, 1e-4);
}

TEST_F(PutDown, NotOnASlope) {
  SceneObject slope = table();
  slope.world_from_object.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
  EXPECT_FALSE(put_block(scene_of({slope}), {0, 0, 0.3}));
}

TEST_F(PutDown, NotFromWithinOrThroughASolid) {
  EXPECT_FALSE(put_block(scene_of({table()}), {0, 0, -0.05}));
  const SceneObject shelf = solid({0.2, 0.2, 0.002}, {0, 0, 0.305});
  EXPECT_FALSE(put_block(scene_of({table(), shelf}), {0, 0, 0.3}));
  EXPECT_TRUE(put_block(scene_of({table(), shelf}), {0, 0, 0.2}));
}

TEST_F(PutDown, EveryKindLiesOnATableInItsLikeliestOrientation) {
  const Scene scene = scene_of({table()});
  const RayCaster surface(scene);
  for (const DebrisKind& kind : debris_catalogue()) {
    const std::vector<Part> parts = make_debris(kind.name, 5);
    const auto world_from_body =
        put_down(surface, parts, resting_orientations(parts).front(), 77.0, {0, 0, 0.3});
    ASSERT_TRUE(world_from_body) << kind.name;
    EXPECT_NEAR(lowest_z_m(parts, *world_from_body), 0.0, 1e-4) << kind.name;
  }
}

}  // namespace
}  // namespace rva
