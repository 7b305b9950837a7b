// What the sections of a scene file say in the same words.
#pragma once

#include "sim/scene/scene.hpp"
#include "sim/scene/yaml_node.hpp"

namespace rva {

/// Places and lengths that a scene may hold, metres.
inline constexpr NumberRange place_range_m{-100.0, 100.0};

/// Three numbers.
[[nodiscard]] Eigen::Vector3d read_vector(const YamlNode& value, NumberRange range);
/// Two numbers.
[[nodiscard]] Eigen::Vector2d read_pair(const YamlNode& value, NumberRange range);

/// `at_m`, and `turn_deg` if it is there: about the world's x, then y, then z.
[[nodiscard]] Transform read_pose(const YamlNode& object);

/// `material`
[[nodiscard]] const Material& read_material(const YamlNode& object);

/// `debris: true` marks what the work left behind.
[[nodiscard]] Role read_role(const YamlNode& object);

/// @throws Error at the name's line when an object of the scene has this name already
void require_new_name(const Scene& scene, const std::string& name, const YamlNode& named);

}  // namespace rva
