// The `debris` section of a scene file.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/scene/scene.hpp"
#include "sim/scene/yaml_node.hpp"

namespace rva {

/// Drops debris in the order of the section onto what the scene holds so far, and gives names to what has
/// none.
/// @param seed for debris at random, instead of the section's
/// @throws Error also for debris that does not come to rest, or lies outside the bay
void add_debris(const YamlNode& section, std::optional<std::uint64_t> seed, Scene& scene);

}  // namespace rva
