// Scenes as files (docs/scenes.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "sim/scene/scene.hpp"

namespace rva {

/// What a command may change of a scene as it loads it.
struct SceneOverrides {
  std::optional<std::filesystem::path>
      debris_file{};                            ///< its `debris` section takes the place of the scene's
  bool no_debris = false;                       ///< the bay as it was before the work: without `work`, too
  std::optional<std::uint64_t> debris_seed{};   ///< for debris placed at random, instead of the file's
  std::optional<Eigen::Vector3d> position_m{};  ///< the robot's foot
  std::optional<double> pan_deg{};
  std::optional<double> tilt_deg{};
};

/// @throws Error naming file, line and field: not readable, not YAML, an unknown or missing field, a size
/// that is
///         not positive, an unknown material or kind, a mesh that cannot be read, debris outside the bay or
///         not at rest, the camera inside a solid
[[nodiscard]] Scene load_scene(const std::filesystem::path& file, const SceneOverrides& overrides = {});

/// As load_scene(), from its text; meshes are looked for beside `place`.
[[nodiscard]] Scene parse_scene(const std::string& text, const std::filesystem::path& place,
                                const SceneOverrides& overrides = {});

}  // namespace rva
