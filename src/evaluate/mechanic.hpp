// Puts parts down in a simulated bay where the camera sees them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "geometry/transform.hpp"
#include "scene/ray_caster.hpp"
#include "scene/scene.hpp"

namespace rva {

/// Puts parts down in a bay, upright, in full view of the camera at the bay's stand and within 0.6 m of it.
class Mechanic {
 public:
  /// @param bay without the parts; must outlive this object
  explicit Mechanic(const Scene& bay);

  /// Lowers a part onto the surface below.
  /// @param kind     name in debris_catalogue()
  /// @param at_m     world x and y of its centre of mass
  /// @param turn_deg about the vertical, counterclockwise seen from above
  /// @return empty where the part does not come to rest, leaves the bay, or is not in full view
  [[nodiscard]] std::optional<SceneObject> put(std::string_view kind, const Eigen::Vector2d& at_m,
                                               double turn_deg, Role role) const;

  /// A point of the world in the frame of the camera, metres.
  [[nodiscard]] Eigen::Vector3d seen(const Eigen::Vector3d& world_m) const {
    return camera_from_world_ * world_m;
  }

 private:
  [[nodiscard]] bool is_in_view(const SceneObject& object) const;

  const Scene& bay_;
  RayCaster surface_;
  Eigen::Vector3d camera_m_;
  Transform camera_from_world_;
};

}  // namespace rva
