// Surfaces made of triangles.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/transform.hpp"

namespace rva {

/// Triangles in one frame, metres; corners in counterclockwise order seen from outside, so that normals
/// point outward. A solid is one or more closed surfaces, which may overlap.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into `vertices`

  /// Adds the other mesh's triangles, which are in the same frame.
  void append(const TriangleMesh& other);
};

/// @param b_from_a where the mesh's frame a lies in b
[[nodiscard]] TriangleMesh transformed(const TriangleMesh& mesh_in_a, const Transform& b_from_a);

/// The smallest box along the axes; empty for an empty mesh.
[[nodiscard]] Eigen::AlignedBox3d bounds(const TriangleMesh& mesh);

/// The volume enclosed, cubic metres; parts that overlap count twice. Negative when the triangles face
/// inward.
[[nodiscard]] double volume_m3(const TriangleMesh& mesh);

/// True when every edge is shared by two triangles that run along it in opposite directions.
[[nodiscard]] bool is_closed(const TriangleMesh& mesh);

}  // namespace rva
