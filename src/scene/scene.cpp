#include "scene/scene.hpp"

namespace rva {

TriangleMesh world_mesh(const SceneObject& object) {
  TriangleMesh mesh;
  for (const Part& part : object.parts) mesh.append(transformed(part.mesh, object.world_from_object));
  return mesh;
}

Eigen::Vector3d size_m(const SceneObject& object) {
  Eigen::AlignedBox3d box;
  for (const Part& part : object.parts) box.extend(bounds(part.mesh));
  return box.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(box.sizes());
}

}  // namespace rva
