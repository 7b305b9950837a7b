// Fields that several sections of a scene file share.
#pragma once

#include "core/yaml_node.hpp"
#include "scene/scene.hpp"

namespace rva {

/// The valid range of coordinates in a scene, metres.
inline constexpr NumberRange place_range_m{-100.0, 100.0};

/// A list of three numbers, each within the range. @throws Error naming the field
[[nodiscard]] Eigen::Vector3d read_vector(const YamlNode& value, NumberRange range);

/// A list of two numbers, each within the range. @throws Error naming the field
[[nodiscard]] Eigen::Vector2d read_pair(const YamlNode& value, NumberRange range);

/// Reads world_from_object from `at_m` and, if present, `turn_deg`: rotations about the world's x, then y,
/// then z.
[[nodiscard]] Transform read_pose(const YamlNode& object);

/// Reads the field `material`.
[[nodiscard]] const Material& read_material(const YamlNode& object);

/// Role::debris for `debris: true`, else Role::structure.
[[nodiscard]] Role read_role(const YamlNode& object);

/// Refuses a name that is taken.
/// @throws Error with the line of the name if an object of the scene already has this name
void require_new_name(const Scene& scene, const std::string& name, const YamlNode& named);

}  // namespace rva
