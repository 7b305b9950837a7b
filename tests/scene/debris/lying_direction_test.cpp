#include "scene/debris/lying_direction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/units.hpp"
#include "scene/solids/shapes.hpp"

namespace rva {
namespace {

TriangleMesh moved(const TriangleMesh& mesh, double x_m) {
  return transformed(mesh, Transform(Eigen::Translation3d(x_m, 0, 0)));
}

/// A hammer along x about its centre of mass: the heavy head at -x, the tip of its handle at +x.
std::vector<Part> hammer() {
  return {{moved(box({0.04, 0.06, 0.03}), -0.03), {}}, {moved(box({0.2, 0.02, 0.02}), 0.08), {}}};
}

RestingOrientation turned(double deg) {
  RestingOrientation orientation;
  orientation.floor_from_body = Eigen::AngleAxisd(radians(deg), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  orientation.height_m = 0.015;
  orientation.probability = 1.0;
  return orientation;
}

/// The difference of two directions, -180 to 180 degrees.
double apart_deg(double a_deg, double b_deg) { return std::remainder(a_deg - b_deg, 360.0); }

TEST(LyingDirection, IsThatOfTheLighterEnd) {
  EXPECT_NEAR(lying_direction_deg(hammer(), turned(0)), 0.0, 1e-4);
  std::vector<Part> other_way = hammer();
  for (Part& part : other_way)
    for (Eigen::Vector3f& vertex : part.mesh.vertices) vertex.x() = -vertex.x();
  EXPECT_NEAR(std::abs(lying_direction_deg(other_way, turned(0))), 180.0, 1e-4);
}

TEST(LyingDirection, TurnsWithTheBody) {
  for (double deg = -170.0; deg <= 180.0; deg += 10.0)
    EXPECT_NEAR(apart_deg(lying_direction_deg(hammer(), turned(deg)), deg), 0.0, 1e-4) << deg;
}

// On its back, what was to the left is to the right.
TEST(LyingDirection, IsSeenFromAbove) {
  RestingOrientation on_its_back = turned(0);
  on_its_back.floor_from_body =
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix() *
      turned(30).floor_from_body;
  EXPECT_NEAR(lying_direction_deg(hammer(), on_its_back), -30.0, 1e-4);
}

TEST(LyingDirection, OfASymmetricBodyIsAlongIt) {
  const std::vector<Part> rod{{box({0.1, 0.01, 0.01}), {}}};
  EXPECT_NEAR(std::remainder(lying_direction_deg(rod, turned(20)) - 20.0, 180.0), 0.0, 1e-4);
}

}  // namespace
}  // namespace rva
