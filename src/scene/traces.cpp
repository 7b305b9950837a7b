#include "scene/traces.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/random.hpp"
#include "scene/drop_zone.hpp"
#include "scene/ray_caster.hpp"

namespace rva {
namespace {

float within(double from, double to, Random& random) { return static_cast<float>(random.uniform(from, to)); }

// A random point of the surfaces below the drop height; empty if there is no surface below.
std::optional<Eigen::Vector3f> place_below(const RayCaster& rays, const Scene& scene, Random& random) {
  const Eigen::Vector3d corner = scene.bay.min();
  const Eigen::Vector3d size = scene.bay.sizes();
  const Ray down{{static_cast<float>(corner.x()) + within(0.0, size.x(), random),
                  static_cast<float>(corner.y()) + within(0.0, size.y(), random),
                  static_cast<float>(default_look_down_m(scene))},
                 -Eigen::Vector3f::UnitZ()};
  const std::optional<Hit> hit = rays.cast(down);
  if (!hit) return std::nullopt;
  return down.origin + hit->distance * down.direction;
}

Trace trace_of(TraceKind kind, const Eigen::Vector3f& at_m, Random& random) {
  const float angle_rad = within(0.0, 2.0 * std::numbers::pi, random);
  const float strength = within(0.03, 0.15, random);
  const bool brighter = kind == TraceKind::dust && random.uniform(0.0, 1.0) < 0.5;
  return {kind, at_m, {std::cos(angle_rad), std::sin(angle_rad), 0.0F}, brighter ? strength : -strength};
}

}  // namespace

void leave_traces(const TraceCounts& counts, Scene& scene) {
  if (counts.all() == 0 || scene.bay.isEmpty()) return;
  Random random(mix(counts.seed, 0x77ACE));
  const RayCaster rays(scene);
  for (const auto& [kind, count] :
       {std::pair(TraceKind::dust, counts.dust), std::pair(TraceKind::smear, counts.smears),
        std::pair(TraceKind::fingerprint, counts.fingerprints)}) {
    for (int i = 0; i < count; ++i) {
      if (const auto at_m = place_below(rays, scene, random))
        scene.traces.push_back(trace_of(kind, *at_m, random));
    }
  }
}

}  // namespace rva
