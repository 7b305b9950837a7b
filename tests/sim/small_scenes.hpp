// Scenes of a few boxes.
#pragma once

#include <string>

#include "scene/scene.hpp"
#include "scene/solids/shapes.hpp"

namespace rva::test {

/// Matt and without texture of its own: what it sends back is what falls on it.
inline constexpr Material white{"white", 1.0, 0.0, 1, 0.0, 0.001, {255, 255, 255}};
inline constexpr Material grainy{"grainy", 0.6, 0.0, 1, 0.05, 0.002, {128, 128, 128}};

inline Material with_albedo(double albedo) {
  Material material = white;
  material.infrared_albedo = albedo;
  return material;
}

inline SceneObject box_at(const std::string& name, const Eigen::Vector3d& center_m,
                          const Eigen::Vector3d& size_m, const Material& material = white) {
  SceneObject object;
  object.name = name;
  object.kind = "box";
  object.parts.push_back({box(size_m), material});
  object.world_from_object.translation() = center_m;
  return object;
}

/// A wall that faces a camera at the origin which looks along z.
inline SceneObject wall_at(double distance_m, const Material& material = white) {
  return box_at("wall", {0, 0, distance_m + 0.05}, {12, 12, 0.1}, material);
}

/// A robot whose camera looks level, along y, at a wall.
/// @param distance_m from the camera to the wall
inline Scene room_with_wall(double distance_m) {
  constexpr double camera_forward_m = 0.020;
  Scene scene;
  scene.name = "room";
  scene.stand.tilt_deg = 0.0;
  scene.objects.push_back(
      box_at("wall", {0, camera_forward_m + distance_m + 0.05, 0.25}, {12, 0.1, 12}, grainy));
  scene.lighting.ambient = 0.02;
  return scene;
}

}  // namespace rva::test
