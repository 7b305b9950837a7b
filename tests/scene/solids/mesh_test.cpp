#include "scene/solids/mesh.hpp"

#include <gtest/gtest.h>

#include "scene/scene.hpp"
#include "scene/solids/shapes.hpp"

namespace rva {
namespace {

TriangleMesh moved(const TriangleMesh& mesh, double x_m) {
  return transformed(mesh, Transform(Eigen::Translation3d(x_m, 0, 0)));
}

TriangleMesh inside_out(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  return mesh;
}

TEST(Mesh, OfNothingHasNoExtent) {
  EXPECT_TRUE(bounds(TriangleMesh{}).isEmpty());
  EXPECT_EQ(volume_m3(TriangleMesh{}), 0.0);
}

TEST(Mesh, AppendedKeepsBoth) {
  TriangleMesh two = box({1, 1, 1});
  two.append(moved(box({2, 1, 1}), 5));
  EXPECT_TRUE(is_closed(two));
  EXPECT_NEAR(volume_m3(two), 3.0, 1e-6);
  EXPECT_NEAR(bounds(two).max().x(), 6.0, 1e-6);
  two.append(two);
  EXPECT_NEAR(volume_m3(two), 6.0, 1e-6);
}

TEST(Mesh, VolumeStaysWhereverItLies) {
  const Transform there =
      Eigen::Translation3d(3, -2, 1) * Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized());
  EXPECT_NEAR(volume_m3(transformed(box({0.1, 0.2, 0.3}), there)), 0.006, 1e-7);
}

TEST(Mesh, FacingInwardHasNegativeVolume) { EXPECT_NEAR(volume_m3(inside_out(box({1, 2, 3}))), -6.0, 1e-6); }

TEST(Mesh, IsOpenWhenATriangleIsMissingOrTurned) {
  TriangleMesh open = box({1, 1, 1});
  EXPECT_TRUE(is_closed(open));
  TriangleMesh turned = open;
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_FALSE(is_closed(turned));
  open.triangles.push_back(open.triangles.back());
  EXPECT_FALSE(is_closed(open));
  open.triangles.resize(open.triangles.size() - 2);
  EXPECT_FALSE(is_closed(open));
}

TEST(Scene, ObjectIsSizedAlongItsOwnAxes) {
  SceneObject object;
  object.parts = {{box({1, 2, 3}), {}}, {moved(box({1, 1, 1}), 2), {}}};
  object.world_from_object.rotate(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  object.world_from_object.pretranslate(Eigen::Vector3d(0, 0, 10));
  EXPECT_TRUE(size_m(object).isApprox(Eigen::Vector3d(3, 2, 3), 1e-6));
  const TriangleMesh world = world_mesh(object);
  EXPECT_EQ(world.triangles.size(), 24U);
  EXPECT_NEAR(bounds(world).min().z(), 8.5, 1e-6);
  EXPECT_EQ(size_m(SceneObject{}), Eigen::Vector3d(0, 0, 0));
}

}  // namespace
}  // namespace rva
