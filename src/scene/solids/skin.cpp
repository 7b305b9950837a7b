#include "scene/solids/skin.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "scene/solids/shapes.hpp"

namespace rva {
namespace {

/// The range of a ring's vertices in a mesh.
struct RingOfVertices {
  std::uint32_t first;
  std::uint32_t count;

  [[nodiscard]] bool is_tip() const { return count == 1; }
  [[nodiscard]] std::uint32_t operator[](std::uint32_t i) const { return first + i % count; }
};

RingOfVertices add_ring(TriangleMesh& mesh, const Ring& ring) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3d& point : ring) mesh.vertices.emplace_back(point.cast<float>());
  return {first, static_cast<std::uint32_t>(ring.size())};
}

// At a tip, one triangle of each pair is degenerate and left out.
void join(TriangleMesh& mesh, const RingOfVertices& from, const RingOfVertices& to) {
  assert(from.is_tip() || to.is_tip() || from.count == to.count);
  const std::uint32_t count = std::max(from.count, to.count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!from.is_tip()) mesh.triangles.push_back({from[i], from[i + 1], to[i + 1]});
    if (!to.is_tip()) mesh.triangles.push_back({from[i], to[i + 1], to[i]});
  }
}

Ring middle_of(const Ring& ring) {
  const Eigen::Vector3d sum = std::accumulate(ring.begin(), ring.end(), Eigen::Vector3d(0, 0, 0));
  return {sum / static_cast<double>(ring.size())};
}

/// A circle about the z axis; a single point if the corner is on the axis.
Ring circle(const Eigen::Vector2d& corner_rz, int segments) {
  if (corner_rz.x() == 0.0) return {{0, 0, corner_rz.y()}};
  Ring ring;
  for (int i = 0; i < segments; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / segments;
    ring.emplace_back(corner_rz.x() * std::cos(angle), corner_rz.x() * std::sin(angle), corner_rz.y());
  }
  return ring;
}

std::vector<Ring> circles(std::span<const Eigen::Vector2d> profile_rz, int segments) {
  assert(segments >= 3);
  std::vector<Ring> rings;
  for (const Eigen::Vector2d& corner_rz : profile_rz) rings.push_back(circle(corner_rz, segments));
  return rings;
}

}  // namespace

TriangleMesh skin(std::span<const Ring> rings) {
  assert(rings.size() >= 2);
  TriangleMesh mesh;
  RingOfVertices last = add_ring(mesh, rings.front());
  if (!last.is_tip()) join(mesh, add_ring(mesh, middle_of(rings.front())), last);
  for (const Ring& ring : rings.subspan(1)) {
    const RingOfVertices next = add_ring(mesh, ring);
    join(mesh, last, next);
    last = next;
  }
  if (!last.is_tip()) join(mesh, last, add_ring(mesh, middle_of(rings.back())));
  return mesh;
}

TriangleMesh looped_skin(std::span<const Ring> rings) {
  assert(rings.size() >= 3);
  TriangleMesh mesh;
  const RingOfVertices first = add_ring(mesh, rings.front());
  RingOfVertices last = first;
  for (const Ring& ring : rings.subspan(1)) {
    const RingOfVertices next = add_ring(mesh, ring);
    join(mesh, last, next);
    last = next;
  }
  join(mesh, last, first);
  return mesh;
}

TriangleMesh lathe(std::span<const Eigen::Vector2d> profile_rz_m, int segments) {
  return skin(circles(profile_rz_m, segments));
}

TriangleMesh turned_ring(std::span<const Eigen::Vector2d> loop_rz_m, int segments) {
  return looped_skin(circles(loop_rz_m, segments));
}

TriangleMesh cylinder(double radius_m, double length_m, int segments) {
  const std::array<Eigen::Vector2d, 2> profile_rz_m{{{radius_m, -length_m / 2}, {radius_m, length_m / 2}}};
  return lathe(profile_rz_m, segments);
}

}  // namespace rva
