// Rays against the triangles of a scene, through Embree.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "sim/scene/scene.hpp"

namespace rva {

/// From `origin` along `direction`; lengths are in units of the direction's length.
struct Ray {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;
};

/// The nearest surface on a ray.
struct Hit {
  static constexpr std::uint32_t none = ~0U;

  float distance;        ///< in units of the ray's direction; infinite where nothing was met
  std::uint32_t object;  ///< index into Scene::objects, or `none`
  std::uint32_t part;    ///< index into SceneObject::parts
  std::uint32_t triangle;
  Eigen::Vector3f normal;  ///< outward, unit length, world frame
};

/// The triangles of a scene, ready for rays. Queries are const and may run on several threads.
class RayCaster {
 public:
  explicit RayCaster(const Scene& scene);
  /// As above, of some objects only. Hit::object is still the index into `scene.objects`.
  RayCaster(const Scene& scene, std::span<const std::size_t> objects);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// @param hits one for each ray
  void cast(std::span<const Ray> rays, std::span<Hit> hits) const;

  /// Is anything between the ray's origin and origin + direction?
  /// @param blocked one for each ray
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const;

  /// The nearest surface on one ray; empty where there is none.
  [[nodiscard]] std::optional<Hit> cast(const Ray& ray) const;

  /// The solid that encloses a point: index into Scene::objects; empty in free space.
  [[nodiscard]] std::optional<std::size_t> solid_around(const Eigen::Vector3d& point) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rva
