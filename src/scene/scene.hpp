// Scenes for the simulated camera.
//
// World frame: x along the span (to the right, seen from the access hole), y along the chord (away from it),
// z up; origin on the lower skin at the middle of the bay's near spar. Metres.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "geometry/transform.hpp"
#include "scene/material.hpp"
#include "scene/solids/mesh.hpp"
#include "scene/trace.hpp"

namespace rva {

/// A piece of an object, of one material.
struct Part {
  TriangleMesh mesh;  ///< in the object's frame
  Material material;  ///< of the whole piece
};

/// Why an object is in the scene.
enum class Role {
  structure,
  debris,
  work,  ///< installed or moved by a mechanic as planned: a change, but not debris
  room,
};
/// The names that scene and truth files use.
template <>
inline constexpr auto enum_names<Role> = std::to_array<EnumName<Role>>({
    {Role::structure, "structure"},
    {Role::debris, "debris"},
    {Role::work, "work"},
    {Role::room, "room"},
});

/// An object of a scene, in one or several materials.
struct SceneObject {
  std::string name;                                     ///< unique in its scene: "rib-1", "collar-0.27-2"
  std::string kind;                                     ///< "rib", "stringer", "collar-0.27"
  Role role = Role::structure;                          ///< what it belongs to
  std::vector<Part> parts;                              ///< its pieces
  Transform world_from_object = Transform::Identity();  ///< pose
};

/// A point of light, outside the camera.
struct Lamp {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< world frame, metres
  double strength = 1.0;  ///< irradiance at one metre, relative to the projector's mean at one metre
};

/// Light in a scene besides the projector of the camera.
struct Lighting {
  double ambient = 0.0;     ///< infrared light from all around, relative to the projector's mean at one metre
  double visible = 1.0;     ///< room light for the colour imager: 0 is a closed, dark wing, 1 a lit one
  std::vector<Lamp> lamps;  ///< besides ambient and room light
};

/// The position of the robot's foot and the angles of its joints.
struct CameraStand {
  std::string base = "b1";  ///< name of this position; captures of one base share a world frame
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< world frame, metres
  /// Rotation of the foot about z, counterclockwise seen from above; 0 looks along +y.
  double heading_deg = 0.0;
  double pan_deg = 0.0;     ///< positive is to the left
  double tilt_deg = -18.0;  ///< negative looks down
};

/// A simulated scene in metres, in the world frame.
struct Scene {
  std::string name;                  ///< for the user
  std::vector<SceneObject> objects;  ///< in any order; see label_of()
  std::vector<Trace> traces;         ///< left on surfaces by work
  Lighting lighting;                 ///< of infrared and colour images
  CameraStand stand;                 ///< where the robot stands
  Eigen::AlignedBox3d bay;  ///< the inside of the bay, where debris may lie; empty when there is no wing

  /// The label of objects[i] in a truth image; 0 is no object.
  [[nodiscard]] static int label_of(std::size_t i) { return static_cast<int>(i) + 1; }
};

/// The object's triangles in the world frame.
[[nodiscard]] TriangleMesh world_mesh(const SceneObject& object);

/// The object's extent along its own axes, metres.
[[nodiscard]] Eigen::Vector3d size_m(const SceneObject& object);

}  // namespace rva
