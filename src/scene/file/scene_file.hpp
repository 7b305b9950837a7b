// Scene files (docs/scenes.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace rva {

/// Changes to a scene that a command may make as it loads it.
struct SceneOverrides {
  /// Scene file whose `debris` section replaces that of the scene.
  std::optional<std::filesystem::path> debris_file{};
  bool no_debris = false;                      ///< the bay before the work, without debris and without `work`
  std::optional<std::uint64_t> debris_seed{};  ///< for debris placed at random, instead of the file's seeds
  std::optional<Eigen::Vector3d> position_m{};  ///< the robot's foot
  std::optional<double> pan_deg{};              ///< joint angle; positive is to the left
  std::optional<double> tilt_deg{};             ///< joint angle; positive is up
};

/// Reads a scene file with the meshes that it names.
/// @throws Error naming file, line and field: not readable, not YAML, an unknown or missing field, a value
///         out of range, an unknown material or kind, a mesh that cannot be read, debris outside the bay or
///         not at rest, the camera inside a solid
[[nodiscard]] Scene load_scene(const std::filesystem::path& file, const SceneOverrides& overrides = {});

/// Parses the text of a scene file.
/// @param source path of the file, which need not exist: relative paths of meshes start at its folder
/// @throws Error as load_scene() does
[[nodiscard]] Scene parse_scene(const std::string& text, const std::filesystem::path& source,
                                const SceneOverrides& overrides = {});

}  // namespace rva
