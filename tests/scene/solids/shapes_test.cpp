#include "scene/solids/shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/solids/extrusion.hpp"

namespace rva {
namespace {

constexpr double pi = std::numbers::pi;

/// Area of a regular polygon in a circle of radius 1, over the circle's own.
double roundness(int corners) { return std::sin(2 * pi / corners) / (2 * pi / corners); }

void expect_solid(const TriangleMesh& mesh, double volume, const Eigen::Vector3d& size) {
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume_m3(mesh), volume, 1e-5 * volume);
  EXPECT_TRUE(bounds(mesh).sizes().isApprox(size, 1e-5)) << bounds(mesh).sizes().transpose();
}

void expect_centred(const TriangleMesh& mesh) { EXPECT_LT(bounds(mesh).center().norm(), 1e-6); }

TEST(Shapes, Box) {
  expect_solid(box({1, 2, 3}), 6.0, {1, 2, 3});
  expect_centred(box({1, 2, 3}));
}

TEST(Shapes, PrismStandsOnItsOutline) {
  const std::array<Eigen::Vector2d, 3> outline{{{0, 0}, {3, 0}, {0, 4}}};
  const TriangleMesh mesh = prism(outline, 2.0);
  expect_solid(mesh, 12.0, {3, 4, 2});
  EXPECT_TRUE(bounds(mesh).min().isZero(1e-6));
}

TEST(Shapes, CylinderTendsToTheRound) {
  for (const int segments : {4, 12, 96}) {
    const TriangleMesh mesh = cylinder(0.5, 2.0, segments);
    expect_solid(mesh, roundness(segments) * pi * 0.25 * 2.0, {1, 1, 2});
    expect_centred(mesh);
  }
  EXPECT_GT(roundness(96), 0.999);
}

TEST(Shapes, LatheMakesConesAndRecesses) {
  const std::array<Eigen::Vector2d, 2> cone{{{1, 0}, {0, 3}}};
  expect_solid(lathe(cone, 64), roundness(64) * pi, {2, 2, 3});
  const std::array<Eigen::Vector2d, 5> cup{{{0, 0}, {2, 0}, {2, 3}, {1, 3}, {1, 1}}};
  expect_solid(lathe(cup, 64), roundness(64) * pi * (4 * 3 - 1 * 2), {4, 4, 3});
}

TEST(Shapes, TubeHasABore) {
  expect_solid(tube(1.0, 0.5, 2.0, 48), roundness(48) * pi * 0.75 * 2.0, {2, 2, 2});
  expect_centred(tube(1.0, 0.5, 2.0, 48));
}

TEST(Shapes, TubeOfSixCornersIsANut) {
  const double volume = (roundness(6) - 0.25 * roundness(30)) * pi * 1.0;
  expect_solid(tube(1.0, 0.5, 1.0, 30, 6), volume, {2, std::sqrt(3.0), 1});
}

TEST(Shapes, RodKeepsItsThicknessAroundCorners) {
  const double across = roundness(16) * pi * 0.01;
  const std::array<Eigen::Vector3d, 2> straight{{{0, 0, 0}, {0, 0, 2}}};
  EXPECT_NEAR(volume_m3(rod(straight, 0.1, 16)), 2 * across, 1e-6);
  const std::array<Eigen::Vector3d, 4> bent{{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 2, 1}}};
  EXPECT_TRUE(is_closed(rod(bent, 0.1, 16)));
  EXPECT_NEAR(volume_m3(rod(bent, 0.1, 16)), 4 * across, 1e-6);
}

TEST(Shapes, PlateWithoutHolesIsABox) { expect_solid(plate({3, 2, 0.1}, {}), 0.6, {3, 2, 0.1}); }

TEST(Shapes, PlateLosesItsHoles) {
  std::vector<RoundHole> holes;
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-0.5, 0.5}) holes.push_back({{x, y}, 0.45, 0.3});
  }
  const TriangleMesh mesh = plate({3, 2, 0.1}, holes);
  expect_solid(mesh, 0.1 * (6.0 - 6 * roundness(64) * pi * 0.45 * 0.3), {3, 2, 0.1});
  expect_centred(mesh);
}

// The triangles' areas add up as they must only if none lies over another.
TEST(Shapes, OutlineMayBeConcave) {
  const Outline comb{{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {3, 1},
                     {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const std::vector<Outline> holes{ellipse({0.5, 0.5}, 0.2, 0.2, 7), ellipse({4.5, 0.5}, 0.3, 0.2, 9)};
  const double bores = pi * (roundness(7) * 0.04 + roundness(9) * 0.06);
  const TriangleMesh mesh = extrude(comb, holes, 1.0);
  expect_solid(mesh, 8.0 - bores, {5, 2, 1});
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f normal =
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]) / 2;
    area += std::abs(static_cast<double>(normal.z()));
  }
  EXPECT_NEAR(area, 2 * (8.0 - bores), 1e-5);
}

TEST(Shapes, SheetFollowsItsHeights) {
  std::vector<double> heights;
  for (int i = 0; i < 5 * 3; ++i) heights.push_back(0.1 * (i % 5));
  const TriangleMesh mesh = sheet(heights, 5, 0.25, 0.02);
  expect_solid(mesh, 1.0 * 0.5 * 0.02, {1, 0.5, 0.42});
  EXPECT_NEAR(bounds(mesh).min().z(), 0.0, 1e-7);
}

}  // namespace
}  // namespace rva
