#include "scene/solids/triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/random.hpp"

namespace rva {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// A region by its corners: the outline counterclockwise, holes clockwise.
struct Region2 {
  Points points;
  std::vector<Loop> loops;

  void add(const Points& corners) {
    Loop loop(corners.size());
    std::iota(loop.begin(), loop.end(), static_cast<std::uint32_t>(points.size()));
    points.insert(points.end(), corners.begin(), corners.end());
    loops.push_back(loop);
  }
};

double area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d ab = b - a;
  const Eigen::Vector2d ac = c - a;
  return (ab.x() * ac.y() - ab.y() * ac.x()) / 2.0;
}

/// The area that loops enclose, by Gauss's formula; holes count negatively.
double area(const Region2& region) {
  double sum = 0.0;
  for (const Loop& loop : region.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Eigen::Vector2d& from = region.points[loop[i]];
      const Eigen::Vector2d& to = region.points[loop[(i + 1) % loop.size()]];
      sum += (from.x() * to.y() - to.x() * from.y()) / 2.0;
    }
  }
  return sum;
}

/// By the number of edges that a ray to the right crosses.
bool is_inside(const Region2& region, const Eigen::Vector2d& point) {
  bool inside = false;
  for (const Loop& loop : region.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Eigen::Vector2d& from = region.points[loop[i]];
      const Eigen::Vector2d& to = region.points[loop[(i + 1) % loop.size()]];
      if ((from.y() > point.y()) == (to.y() > point.y())) continue;
      const double x = from.x() + (point.y() - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
      if (x > point.x()) inside = !inside;
    }
  }
  return inside;
}

// Counterclockwise triangles inside the region whose areas sum up to its own lie nowhere over another.
void expect_triangulated(const Region2& region) {
  const auto triangles = triangulate(region.points, region.loops);
  const std::size_t corners = region.points.size();
  EXPECT_EQ(triangles.size(), corners + 2 * (region.loops.size() - 1) - 2) << "Euler";
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector2d& first = region.points[a];
    const Eigen::Vector2d& second = region.points[b];
    const Eigen::Vector2d& third = region.points[c];
    EXPECT_GT(area(first, second, third), 0.0);
    EXPECT_TRUE(is_inside(region, (first + second + third) / 3.0));
    sum += area(first, second, third);
  }
  EXPECT_NEAR(sum, area(region), 1e-9);
}

/// A star-shaped outline of random radii: mostly concave.
Points star(const Eigen::Vector2d& centre, double least, double most, int corners, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    points.emplace_back(centre +
                        random.uniform(least, most) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

Points clockwise(Points points) {
  std::ranges::reverse(points);
  return points;
}

TEST(Triangulation, OfATriangleIsItself) {
  Region2 region;
  region.add({{0, 0}, {1, 0}, {0, 1}});
  expect_triangulated(region);
}

TEST(Triangulation, CoversConcaveOutlines) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Region2 region;
    region.add(star({3.0, -2.0}, 0.2, 1.0, 5 + static_cast<int>(seed), seed));
    expect_triangulated(region);
  }
}

TEST(Triangulation, LeavesHolesOpen) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Region2 region;
    region.add(star({0, 0}, 4.0, 6.0, 16, seed));
    for (int k = 0; k < 5; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / 5.0;
      const Eigen::Vector2d centre = 2.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      region.add(clockwise(star(centre, 0.2, 1.0, 7, 100 * seed + static_cast<std::uint64_t>(k))));
    }
    expect_triangulated(region);
  }
}

/// A square hole, clockwise.
Points square_hole(double left, double bottom, double size) {
  return {{left, bottom}, {left, bottom + size}, {left + size, bottom + size}, {left + size, bottom}};
}

// The corner nearest to the hole is on the other side of a gap.
TEST(Triangulation, ConnectsHolesToCornersThatTheySee) {
  Region2 region;
  region.add({{0, 0}, {10, 0}, {10, 10}, {5.2, 10}, {5.2, 5}, {5.2, 1}, {5, 1}, {5, 10}, {0, 10}});
  region.add(square_hole(4.0, 4.5, 0.9));
  expect_triangulated(region);
}

// Both holes are nearest to the tip between them; either may be connected first.
TEST(Triangulation, ConnectsHolesOnBothSidesOfATip) {
  for (const double left : {1.0, 1.1}) {
    Region2 region;
    region.add({{-10, -10}, {-1, -10}, {0, 0}, {1, -10}, {10, -10}, {10, 10}, {-10, 10}});
    region.add(square_hole(-left - 1.0, 0.5, 1.0));
    region.add(square_hole(1.05, 0.5, 1.0));
    expect_triangulated(region);
  }
}

// Bridges along a row of holes meet at corners that already have one.
TEST(Triangulation, TakesRowsOfHoles) {
  Region2 region;
  region.add({{-1, -1}, {21, -1}, {21, 3}, {-1, 3}});
  for (int column = 0; column < 10; ++column) {
    for (int row = 0; row < 2; ++row) {
      region.add(square_hole(2.0 * column, 1.4 * row, 1.0));
    }
  }
  expect_triangulated(region);
}

}  // namespace
}  // namespace rva
