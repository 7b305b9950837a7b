// The sections `solids` and `meshes` of a scene file: objects placed by hand.
#pragma once

#include <filesystem>

#include "sim/scene/scene.hpp"
#include "sim/scene/yaml_node.hpp"

namespace rva {

/// Boxes, cylinders and planes.
void add_solids(const YamlNode& section, Scene& scene);

/// Files of triangles. @param folder where relative names start
void add_meshes(const YamlNode& section, const std::filesystem::path& folder, Scene& scene);

}  // namespace rva
