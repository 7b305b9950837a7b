// The sections `solids` and `meshes` of a scene file: objects placed by hand.
#pragma once

#include <filesystem>

#include "core/yaml_node.hpp"
#include "scene/scene.hpp"

namespace rva {

/// Adds boxes, cylinders and planes.
void add_solids(const YamlNode& section, Scene& scene);

/// Adds meshes from files.
/// @param folder folder of the scene file, where relative paths start
void add_meshes(const YamlNode& section, const std::filesystem::path& folder, Scene& scene);

}  // namespace rva
