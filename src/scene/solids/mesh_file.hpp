// Mesh files of other programs.
#pragma once

#include <filesystem>

#include "scene/solids/mesh.hpp"

namespace rva {

/// Reads an OBJ or STL file, according to its extension. A closed surface that faces inward is reversed.
/// @param unit_m length of one unit of the file, in metres
/// @throws Error if the file cannot be read, contains no triangles or more than 5 million, or has coordinates
///         that are not finite or beyond 100 m
[[nodiscard]] TriangleMesh load_mesh(const std::filesystem::path& file, double unit_m);

}  // namespace rva
