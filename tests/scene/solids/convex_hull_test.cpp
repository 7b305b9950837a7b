#include "scene/solids/convex_hull.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/random.hpp"
#include "scene/solids/mesh.hpp"
#include "scene/solids/shapes.hpp"

namespace rva {
namespace {

TriangleMesh hull_of(const std::vector<Eigen::Vector3d>& points) {
  TriangleMesh mesh;
  for (const Eigen::Vector3d& point : points) mesh.vertices.emplace_back(point.cast<float>());
  mesh.triangles = convex_hull(points);
  return mesh;
}

std::vector<Eigen::Vector3d> random_points(int count) {
  Random random(7);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(random.uniform(-1, 1), random.uniform(-2, 2), random.uniform(-3, 3));
  }
  return points;
}

TEST(ConvexHull, HasEveryPointBehindEachTriangle) {
  const std::vector<Eigen::Vector3d> points = random_points(200);
  const TriangleMesh hull = hull_of(points);
  EXPECT_TRUE(is_closed(hull));
  for (const auto& [a, b, c] : hull.triangles) {
    const Eigen::Vector3d normal = (points[b] - points[a]).cross(points[c] - points[a]).normalized();
    for (const Eigen::Vector3d& point : points) EXPECT_LT(normal.dot(point - points[a]), 1e-4);
  }
}

// Points by the dozen in one plane and on one line are what shapes are made of.
TEST(ConvexHull, OfAGridIsItsBox) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 6 * 6 * 6; ++i) points.emplace_back(i % 6, i / 6 % 6, i / 36);
  const TriangleMesh hull = hull_of(points);
  EXPECT_TRUE(is_closed(hull));
  EXPECT_NEAR(volume_m3(hull), 125.0, 0.01);
}

TEST(ConvexHull, OfABodyTwiceIsTheBody) {
  TriangleMesh mesh = cylinder(0.01, 0.05, 48);
  mesh.append(mesh);
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& vertex : mesh.vertices) points.emplace_back(vertex.cast<double>());
  const TriangleMesh hull = hull_of(points);
  EXPECT_TRUE(is_closed(hull));
  EXPECT_NEAR(volume_m3(hull), volume_m3(mesh) / 2, 1e-4 * volume_m3(mesh));
}

TEST(ConvexHull, OfFlatOrFewPointsIsEmpty) {
  EXPECT_TRUE(convex_hull(std::span<const Eigen::Vector3d>()).empty());
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 25; ++i) points.emplace_back(i % 5, i / 5, i % 5);
  EXPECT_TRUE(convex_hull(points).empty());
}

TEST(ConvexHull, InThePlaneKeepsTheCornersOnly) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 25; ++i) points.emplace_back(i % 5, i / 5);
  const std::vector<Eigen::Vector2d> corners{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(convex_hull(points), corners);
}

TEST(ConvexHull, DepthIsTheDistanceToTheNearestEdge) {
  const std::vector<Eigen::Vector2d> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_DOUBLE_EQ(depth_inside(square, {1, 2}), 1.0);
  EXPECT_LT(depth_inside(square, {5, 2}), 0.0);
  EXPECT_LT(depth_inside(convex_hull(std::vector<Eigen::Vector2d>{{0, 0}, {1, 1}}), {0.5, 0.5}), 0.0);
}

}  // namespace
}  // namespace rva
