#include "scene/solids/extrusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "scene/solids/shapes.hpp"
#include "scene/solids/triangulation.hpp"

namespace rva {
namespace {

constexpr int hole_corners = 64;

Loop add_loop(Outline& points, std::span<const Eigen::Vector2d> outline) {
  Loop loop(outline.size());
  std::iota(loop.begin(), loop.end(), static_cast<std::uint32_t>(points.size()));
  points.insert(points.end(), outline.begin(), outline.end());
  return loop;
}

void add_face(TriangleMesh& mesh, const Outline& points, double z_m) {
  for (const Eigen::Vector2d& point : points) {
    mesh.vertices.emplace_back(Eigen::Vector3d(point.x(), point.y(), z_m).cast<float>());
  }
}

TriangleMesh centred_along_z(const TriangleMesh& mesh, double length_m) {
  return transformed(mesh, Transform(Eigen::Translation3d(0, 0, -length_m / 2)));
}

}  // namespace

Outline ellipse(const Eigen::Vector2d& center_m, double radius_u_m, double radius_v_m, int corners) {
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    outline.emplace_back(center_m.x() + radius_u_m * std::cos(angle),
                         center_m.y() + radius_v_m * std::sin(angle));
  }
  return outline;
}

TriangleMesh extrude(std::span<const Eigen::Vector2d> outline_m, std::span<const Outline> holes_m,
                     double length_m) {
  Outline points;
  std::vector<Loop> loops{add_loop(points, outline_m)};
  for (const Outline& hole : holes_m) {
    loops.push_back(add_loop(points, hole));
    std::reverse(loops.back().begin(), loops.back().end());
  }

  TriangleMesh mesh;
  add_face(mesh, points, 0.0);
  add_face(mesh, points, length_m);
  const auto up = static_cast<std::uint32_t>(points.size());
  for (const auto& [a, b, c] : triangulate(points, loops)) {
    mesh.triangles.push_back({c, b, a});
    mesh.triangles.push_back({a + up, b + up, c + up});
  }
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t from = loop[i];
      const std::uint32_t to = loop[(i + 1) % loop.size()];
      mesh.triangles.push_back({from, to, to + up});
      mesh.triangles.push_back({from, to + up, from + up});
    }
  }
  return mesh;
}

TriangleMesh prism(std::span<const Eigen::Vector2d> outline_m, double length_m) {
  return extrude(outline_m, {}, length_m);
}

TriangleMesh box(const Eigen::Vector3d& size_m) {
  const double x = size_m.x() / 2;
  const double y = size_m.y() / 2;
  const std::array<Eigen::Vector2d, 4> outline_m{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
  return centred_along_z(prism(outline_m, size_m.z()), size_m.z());
}

TriangleMesh tube(double outer_radius_m, double inner_radius_m, double length_m, int segments,
                  int outer_corners) {
  const int corners = outer_corners > 0 ? outer_corners : segments;
  const Outline outline_m = ellipse({0, 0}, outer_radius_m, outer_radius_m, corners);
  const std::vector<Outline> bore_m{ellipse({0, 0}, inner_radius_m, inner_radius_m, segments)};
  return centred_along_z(extrude(outline_m, bore_m, length_m), length_m);
}

TriangleMesh plate(const Eigen::Vector3d& size_m, std::span<const RoundHole> holes) {
  const double x = size_m.x() / 2;
  const double y = size_m.y() / 2;
  const Outline outline_m{{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  std::vector<Outline> outlines_m;
  for (const RoundHole& hole : holes) {
    outlines_m.push_back(ellipse(hole.center_m, hole.radius_u_m, hole.radius_v_m, hole_corners));
  }
  return centred_along_z(extrude(outline_m, outlines_m, size_m.z()), size_m.z());
}

}  // namespace rva
