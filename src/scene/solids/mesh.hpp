// Triangle meshes.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/transform.hpp"

namespace rva {

/// Triangles in one frame, in metres. Corners are in counterclockwise order seen from outside, so that
/// normals point outward. A solid consists of one or more closed surfaces, which may overlap.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;                ///< corners, metres
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into `vertices`

  /// Adds the other mesh's triangles, which are in the same frame.
  void append(const TriangleMesh& other);
};

/// Transforms a mesh from frame a to frame b.
[[nodiscard]] TriangleMesh transformed(const TriangleMesh& mesh_in_a, const Transform& b_from_a);

/// The axis-aligned bounding box; empty for an empty mesh.
[[nodiscard]] Eigen::AlignedBox3d bounds(const TriangleMesh& mesh);

/// The enclosed volume in cubic metres; parts that overlap count twice. Negative if the
/// triangles face inward.
[[nodiscard]] double volume_m3(const TriangleMesh& mesh);

/// True if every edge is shared by exactly two triangles, which run along it in opposite directions.
[[nodiscard]] bool is_closed(const TriangleMesh& mesh);

}  // namespace rva
