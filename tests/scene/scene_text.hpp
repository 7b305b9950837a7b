// Scenes from text, and what is in them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "scene/file/scene_file.hpp"

namespace rva::test {

inline const std::string scene_head = "format: rva-scene\nversion: 1\n";
/// The wing of the thesis, its robot just inside.
inline const std::string bay_head = scene_head + "robot: { at_m: [0, 0.10, 0], tilt_deg: -20 }\nwing: {}\n";

inline Scene parsed(const std::string& text, const SceneOverrides& overrides = {}) {
  return parse_scene(text, "scene.yaml", overrides);
}

inline SceneOverrides with_seed(std::uint64_t seed) {
  SceneOverrides overrides;
  overrides.debris_seed = seed;
  return overrides;
}

inline SceneOverrides with_robot_at(const Eigen::Vector3d& position_m) {
  SceneOverrides overrides;
  overrides.position_m = position_m;
  return overrides;
}

inline SceneOverrides with_debris_of(const std::filesystem::path& file) {
  SceneOverrides overrides;
  overrides.debris_file = file;
  return overrides;
}

inline SceneOverrides without_debris() {
  SceneOverrides overrides;
  overrides.no_debris = true;
  return overrides;
}

inline const SceneObject& named(const Scene& scene, const std::string& name) {
  return *std::find_if(scene.objects.begin(), scene.objects.end(),
                       [&](const SceneObject& object) { return object.name == name; });
}

inline Eigen::AlignedBox3d extent_of(const Scene& scene, const std::string& name) {
  return bounds(world_mesh(named(scene, name)));
}

inline std::vector<std::string> debris_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneObject& object : scene.objects) {
    if (object.role == Role::debris) names.push_back(object.name);
  }
  return names;
}

}  // namespace rva::test
