#include "scene/drop_zone.hpp"

#include <algorithm>

namespace rva {

double default_look_down_m(const Scene& scene) {
  if (!scene.bay.isEmpty()) return scene.bay.center().z();
  constexpr double headroom_m = 0.5;
  double top_m = 0;
  for (const SceneObject& object : scene.objects)
    top_m = std::max(top_m, bounds(world_mesh(object)).max().z());
  return top_m + headroom_m;
}

bool lies_inside(const Scene& scene, const SceneObject& object) {
  if (scene.bay.isEmpty()) return true;
  // An object on the skin touches the bay's boundary, except for rounding.
  constexpr double rounding_m = 2e-4;
  const Eigen::Vector3d slack = Eigen::Vector3d::Constant(rounding_m);
  return Eigen::AlignedBox3d(scene.bay.min() - slack, scene.bay.max() + slack)
      .contains(bounds(world_mesh(object)));
}

}  // namespace rva
