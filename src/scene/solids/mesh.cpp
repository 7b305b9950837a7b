#include "scene/solids/mesh.hpp"

#include <algorithm>
#include <utility>

namespace rva {

void TriangleMesh::append(const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  vertices.reserve(vertices.size() + other.vertices.size());
  triangles.reserve(triangles.size() + other.triangles.size());
  // Indexed and sized beforehand, so that a mesh can be appended to itself.
  for (std::size_t i = 0, count = other.vertices.size(); i < count; ++i) {
    vertices.push_back(other.vertices[i]);
  }
  for (std::size_t i = 0, count = other.triangles.size(); i < count; ++i) {
    const auto [a, b, c] = other.triangles[i];
    triangles.push_back({first + a, first + b, first + c});
  }
}

TriangleMesh transformed(const TriangleMesh& mesh_in_a, const Transform& b_from_a) {
  TriangleMesh mesh_in_b = mesh_in_a;
  for (Eigen::Vector3f& vertex : mesh_in_b.vertices) {
    const Eigen::Vector3d moved = b_from_a * vertex.cast<double>();
    vertex = moved.cast<float>();
  }
  return mesh_in_b;
}

Eigen::AlignedBox3d bounds(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex.cast<double>());
  return box;
}

// The sum of the signed volumes of the tetrahedra between the triangles and one point; those whose triangle
// faces the point are negative.
double volume_m3(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  const Eigen::Vector3d apex = bounds(mesh).center();
  double six_volumes = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d to_a = mesh.vertices[a].cast<double>() - apex;
    const Eigen::Vector3d to_b = mesh.vertices[b].cast<double>() - apex;
    const Eigen::Vector3d to_c = mesh.vertices[c].cast<double>() - apex;
    six_volumes += to_a.dot(to_b.cross(to_c));
  }
  return six_volumes / 6.0;
}

bool is_closed(const TriangleMesh& mesh) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
  }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
  return std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
    return std::binary_search(edges.begin(), edges.end(), Edge(edge.second, edge.first));
  });
}

}  // namespace rva
