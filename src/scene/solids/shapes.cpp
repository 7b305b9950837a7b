#include "scene/solids/shapes.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "scene/solids/skin.hpp"

namespace rva {
namespace {

Ring ring_across(const Eigen::Vector3d& center, const Eigen::Vector3d& along, double radius_m, int segments) {
  const Eigen::Vector3d u = along.unitOrthogonal();
  const Eigen::Vector3d v = along.cross(u);
  Ring ring;
  for (int i = 0; i < segments; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / segments;
    ring.push_back(center + radius_m * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return ring;
}

/// Slides a ring along a straight piece of rod onto the plane in which the piece ends.
Ring slid(Ring ring, const Eigen::Vector3d& along, const Eigen::Vector3d& end,
          const Eigen::Vector3d& normal) {
  for (Eigen::Vector3d& point : ring) point += along * ((end - point).dot(normal) / along.dot(normal));
  return ring;
}

/// Vertex indices of a grid with a lower and an upper layer.
struct TwoLayers {
  std::uint32_t rows;
  std::uint32_t columns;

  [[nodiscard]] std::uint32_t lower(std::uint32_t row, std::uint32_t column) const {
    return row * columns + column;
  }
  [[nodiscard]] std::uint32_t above(std::uint32_t lower_vertex) const {
    return lower_vertex + rows * columns;
  }
};

/// The lower layer's vertices along its edge, counterclockwise seen from above.
std::vector<std::uint32_t> edge_of(const TwoLayers& grid) {
  std::vector<std::uint32_t> edge;
  const std::uint32_t row = grid.rows - 1;
  const std::uint32_t column = grid.columns - 1;
  for (std::uint32_t i = 0; i < column; ++i) edge.push_back(grid.lower(0, i));
  for (std::uint32_t i = 0; i < row; ++i) edge.push_back(grid.lower(i, column));
  for (std::uint32_t i = column; i > 0; --i) edge.push_back(grid.lower(row, i));
  for (std::uint32_t i = row; i > 0; --i) edge.push_back(grid.lower(i, 0));
  return edge;
}

void add_wall(TriangleMesh& mesh, const TwoLayers& grid) {
  const std::vector<std::uint32_t> edge = edge_of(grid);
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const std::uint32_t from = edge[i];
    const std::uint32_t to = edge[(i + 1) % edge.size()];
    mesh.triangles.push_back({from, to, grid.above(to)});
    mesh.triangles.push_back({from, grid.above(to), grid.above(from)});
  }
}

void add_layers(TriangleMesh& mesh, const TwoLayers& grid) {
  for (std::uint32_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < grid.columns; ++column) {
      const std::uint32_t a = grid.lower(row, column);
      const std::uint32_t b = grid.lower(row, column + 1);
      const std::uint32_t c = grid.lower(row + 1, column + 1);
      const std::uint32_t d = grid.lower(row + 1, column);
      mesh.triangles.push_back({c, b, a});
      mesh.triangles.push_back({d, c, a});
      mesh.triangles.push_back({grid.above(a), grid.above(b), grid.above(c)});
      mesh.triangles.push_back({grid.above(a), grid.above(c), grid.above(d)});
    }
  }
}

}  // namespace

// Neighbouring pieces meet in the plane that bisects their angle, so that the rod's thickness is constant.
TriangleMesh rod(std::span<const Eigen::Vector3d> path_m, double radius_m, int segments) {
  assert(path_m.size() >= 2);
  Eigen::Vector3d along = (path_m[1] - path_m[0]).normalized();
  std::vector<Ring> rings{ring_across(path_m[0], along, radius_m, segments)};
  for (std::size_t i = 1; i < path_m.size(); ++i) {
    const Eigen::Vector3d next =
        i + 1 < path_m.size() ? Eigen::Vector3d((path_m[i + 1] - path_m[i]).normalized()) : along;
    rings.push_back(slid(rings.back(), along, path_m[i], along + next));
    along = next;
  }
  return skin(rings);
}

TriangleMesh sheet(std::span<const double> heights_m, int columns, double pitch_m, double thickness_m) {
  const auto across = static_cast<std::uint32_t>(columns);
  const TwoLayers grid{static_cast<std::uint32_t>(heights_m.size()) / across, across};
  assert(grid.rows >= 2 && grid.columns >= 2 && heights_m.size() == grid.rows * grid.columns);
  TriangleMesh mesh;
  for (const double layer_m : {0.0, thickness_m}) {
    for (std::uint32_t i = 0; i < grid.rows * grid.columns; ++i) {
      const double x_m = pitch_m * (i % across - (grid.columns - 1) / 2.0);
      const std::uint32_t row = i / across;
      const double y_m = pitch_m * (row - (grid.rows - 1) / 2.0);
      mesh.vertices.emplace_back(Eigen::Vector3d(x_m, y_m, heights_m[i] + layer_m).cast<float>());
    }
  }
  add_layers(mesh, grid);
  add_wall(mesh, grid);
  return mesh;
}

}  // namespace rva
