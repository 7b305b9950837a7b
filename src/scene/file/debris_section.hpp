// The `debris` section of a scene file, and the parts of its `work` section, which are placed likewise.
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

/// Adds the parts that the work installed, in the order of the list, each as an entry of `debris` placed by
/// hand.
/// @throws Error as add_debris()
void add_planned_parts(const YamlNode& section, Scene& scene);

}  // namespace rva
