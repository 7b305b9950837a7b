// The surfaces hit by one row of rays.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/ray_caster.hpp"
#include "scene/scene.hpp"
#include "sim/sensor/surface_light.hpp"

namespace rva {

/// The work on a row of samples that both renderers share. Reuses its buffers from row to row, and
/// is not thread-safe.
class SurfaceRow {
 public:
  /// The scene and the caster must outlive the row.
  SurfaceRow(const Scene& scene, const RayCaster& caster, std::size_t samples);

  /// The rays, which the caller must set before cast(). Directions need not be of unit length.
  [[nodiscard]] std::vector<Ray>& rays() { return rays_; }
  /// Casts the rays and finds the surfaces that they hit.
  void cast();
  /// Determines for lit() which samples a point light at `light_m` (world) reaches. Call after cast().
  void find_shadows(const Eigen::Vector3f& light_m);

  /// Number of samples.
  [[nodiscard]] std::size_t samples() const { return rays_.size(); }
  /// Whether the ray of sample i hit a surface.
  [[nodiscard]] bool seen(std::size_t i) const { return hits_[i].object != Hit::none; }
  /// Whether the light of the last find_shadows() reaches sample i.
  [[nodiscard]] bool lit(std::size_t i) const { return seen(i) && shaded_[i] == 0; }

  /// @name Surfaces
  /// Valid only for samples for which seen() is true.
  /// @{

  /// Position and normal of the surface, world frame.
  [[nodiscard]] const SurfacePoint& point(std::size_t i) const { return points_[i]; }
  /// Material of the surface.
  [[nodiscard]] const Material& material(std::size_t i) const { return *materials_[i]; }
  /// Factor of the diffuse reflectance: grain and traces.
  [[nodiscard]] float grain(std::size_t i) const { return grains_[i]; }

  /// @}

 private:
  const Scene& scene_;
  const RayCaster& caster_;
  std::vector<Ray> rays_;
  std::vector<Ray> shadow_rays_;
  std::vector<Hit> hits_;
  std::vector<SurfacePoint> points_;
  std::vector<const Material*> materials_;
  std::vector<float> grains_;
  std::vector<std::uint8_t> shaded_;
};

}  // namespace rva
