// Triangles that other programs wrote.
#pragma once

#include <filesystem>

#include "sim/scene/mesh.hpp"

namespace rva {

/// Reads OBJ, STL or PLY, told by the file's ending. A closed surface that faces inward is turned outward.
/// @param unit_m what a length of 1 in the file means
/// @throws Error when the file cannot be read, or holds no triangles, too many, or no real places
[[nodiscard]] TriangleMesh load_mesh(const std::filesystem::path& file, double unit_m);

}  // namespace rva
