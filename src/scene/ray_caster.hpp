// Ray casting against the triangles of a scene, by Embree.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "scene/scene.hpp"

namespace rva {

/// A ray from `origin` along `direction`. Distances along it are in units of the direction's length.
struct Ray {
  Eigen::Vector3f origin;     ///< world frame, metres
  Eigen::Vector3f direction;  ///< world frame, of any length
};

/// The nearest surface on a ray.
struct Hit {
  static constexpr std::uint32_t none = ~0U;  ///< value of `object` if there is no hit

  float distance;          ///< in units of the ray's direction; infinite if there is no hit
  std::uint32_t object;    ///< index into Scene::objects, or `none`
  std::uint32_t part;      ///< index into SceneObject::parts
  std::uint32_t triangle;  ///< index of the triangle in the mesh of the part
  Eigen::Vector3f normal;  ///< outward, unit length, world frame
};

/// Casts rays against the triangles of a scene. Queries are const and may run on several threads.
class RayCaster {
 public:
  /// @param scene must outlive the caster
  explicit RayCaster(const Scene& scene);
  /// Uses only some of the objects. Hit::object is still the index into `scene.objects`.
  RayCaster(const Scene& scene, std::span<const std::size_t> objects);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// Finds the nearest surface on each ray.
  /// @param hits receives one element for each ray
  void cast(std::span<const Ray> rays, std::span<Hit> hits) const;

  /// Determines for each ray whether a surface lies between its origin and origin + direction.
  /// @param blocked receives one element for each ray: 1 if so, else 0
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const;

  /// The nearest surface on one ray; empty if there is none.
  [[nodiscard]] std::optional<Hit> cast(const Ray& ray) const;

  /// The index into Scene::objects of a solid that encloses the point (world); empty in free space.
  [[nodiscard]] std::optional<std::size_t> solid_around(const Eigen::Vector3d& point) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rva
