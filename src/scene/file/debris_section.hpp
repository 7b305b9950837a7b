// The `debris` section of a scene file.
#pragma once

#include <cstdint>
#include <optional>

#include "core/yaml_node.hpp"
#include "scene/scene.hpp"

namespace rva {

/// Drops the debris of the section, in its order, onto the objects that the scene contains so far, and names
/// the objects that have no name.
/// @param seed for debris placed at random, instead of the section's seeds
/// @throws Error also for debris that does not come to rest, or lies outside the bay
void add_debris(const YamlNode& section, std::optional<std::uint64_t> seed, Scene& scene);

}  // namespace rva
