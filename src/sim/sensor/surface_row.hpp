// The surfaces that one row of rays meets.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/scene/ray_caster.hpp"
#include "sim/scene/scene.hpp"
#include "sim/sensor/surface_light.hpp"

namespace rva {

/// What both renderers do with a row of samples; keeps its buffers from row to row. For one thread.
class SurfaceRow {
 public:
  /// The scene and the caster must outlive the row.
  SurfaceRow(const Scene& scene, const RayCaster& caster, std::size_t samples);

  /// Aim every ray before cast(). Directions need not be of unit length.
  [[nodiscard]] std::vector<Ray>& rays() { return rays_; }
  void cast();
  /// Which samples does a point of light reach? For lit().
  void find_shadows(const Eigen::Vector3f& light_m);

  [[nodiscard]] std::size_t samples() const { return rays_.size(); }
  [[nodiscard]] bool seen(std::size_t i) const { return hits_[i].object != Hit::none; }
  [[nodiscard]] bool lit(std::size_t i) const { return seen(i) && shaded_[i] == 0; }

  // Of a sample that is seen.
  [[nodiscard]] const SurfacePoint& point(std::size_t i) const { return points_[i]; }
  [[nodiscard]] const Material& material(std::size_t i) const { return *materials_[i]; }
  [[nodiscard]] float grain(std::size_t i) const { return grains_[i]; }

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
