#include "scene/solids/skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rva {
namespace {

/// A square about the z axis, counterclockwise seen from above.
Ring square(double half, double z) {
  return {{half, half, z}, {-half, half, z}, {-half, -half, z}, {half, -half, z}};
}

TriangleMesh turned(const TriangleMesh& mesh) {
  const Transform there =
      Eigen::Translation3d(2, -1, 3) * Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized());
  return transformed(mesh, there);
}

TEST(Skin, OfTwoSquaresIsAFrustum) {
  const TriangleMesh mesh = skin(std::array{square(2, 0), square(1, 3)});
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume_m3(mesh), 3.0 / 3.0 * (16.0 + 4.0 + std::sqrt(16.0 * 4.0)), 1e-5);
}

TEST(Skin, EndsInTipsWhereRingsAreSinglePoints) {
  const TriangleMesh pyramid = skin(std::array{square(1, 0), Ring{{0, 0, 3}}});
  EXPECT_TRUE(is_closed(pyramid));
  EXPECT_NEAR(volume_m3(pyramid), 4.0, 1e-5);
  const TriangleMesh octahedron = skin(std::array{Ring{{0, 0, -1}}, square(1, 0), Ring{{0, 0, 1}}});
  EXPECT_TRUE(is_closed(octahedron));
  EXPECT_NEAR(volume_m3(octahedron), 8.0 / 3.0, 1e-5);
  EXPECT_EQ(octahedron.triangles.size(), 8U) << "no degenerate ones";
}

TEST(Skin, FacesOutward) {
  for (const TriangleMesh& mesh : {skin(std::array{square(2, 0), square(1, 3), square(1.5, 4)}),
                                   turned(skin(std::array{square(1, 0), square(1, 1)}))}) {
    EXPECT_GT(volume_m3(mesh), 0.0);
    const Eigen::Vector3f centre = bounds(mesh).center().cast<float>();
    int outward = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Eigen::Vector3f& corner = mesh.vertices[a];
      const Eigen::Vector3f normal = (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner);
      outward += normal.dot(corner - centre) > 0.0F ? 1 : 0;
    }
    EXPECT_EQ(outward, static_cast<int>(mesh.triangles.size()));
  }
}

// Pappus: the volume is the area of the profile times the way of its centroid.
TEST(LoopedSkin, AroundAnAxisHasTheVolumeOfPappus) {
  constexpr int segments = 180;
  const std::array<Eigen::Vector2d, 4> profile{{{2, 0}, {2, 1}, {1, 1}, {1, 0}}};
  const TriangleMesh ring = turned_ring(profile, segments);
  EXPECT_TRUE(is_closed(ring));
  const double polygon = std::sin(2.0 * std::numbers::pi / segments) / (2.0 * std::numbers::pi / segments);
  EXPECT_NEAR(volume_m3(ring), polygon * 2.0 * std::numbers::pi * 1.5, 1e-3);
  EXPECT_NEAR(bounds(ring).sizes().z(), 1.0, 1e-6);
  EXPECT_EQ(ring.vertices.size(), 4U * segments) << "there is a bore, and no end that is closed";
}

TEST(LoopedSkin, IsClosedWithoutEnds) {
  std::vector<Ring> rings;
  for (int i = 0; i < 12; ++i) {
    const Eigen::AngleAxisd about(2.0 * std::numbers::pi * i / 12.0, Eigen::Vector3d::UnitX());
    Ring ring;
    for (const Eigen::Vector3d& corner : square(0.2, 0))
      ring.push_back(about * (corner + Eigen::Vector3d(0, 1, 0)));
    rings.push_back(ring);
  }
  const TriangleMesh mesh = looped_skin(rings);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_EQ(mesh.vertices.size(), 48U);
  EXPECT_EQ(mesh.triangles.size(), 96U);
  EXPECT_GT(volume_m3(mesh), 0.0);
}

}  // namespace
}  // namespace rva
