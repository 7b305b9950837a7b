#include "evaluate/moved_targets.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace rva {
namespace {

bool is_big(const Scene& scene, const std::string& kind) {
  const auto object = std::ranges::find_if(scene.objects, [&](const SceneObject& candidate) {
    return candidate.role == Role::debris && candidate.kind == kind;
  });
  if (object == scene.objects.end()) return false;
  Eigen::Vector3d sides_m = size_m(*object);
  std::sort(sides_m.begin(), sides_m.end());
  return sides_m[0] >= 0.010 && sides_m[1] >= 0.015;
}

// Whether at least half of the target's pixels lie in front of a surface that the initial view measured, with
// a tolerance in disparity.
bool is_seen_free(const Target& target, const Intrinsics& camera, const DepthView& initial,
                  const Transform& initial_from_final) {
  const auto width = static_cast<std::uint32_t>(camera.width);
  std::size_t free = 0;
  for (const std::uint32_t i : target.pixels) {
    const Eigen::Vector3d point =
        initial_from_final * camera.deproject({i % width, i / width}, target.distance_m);
    if (point.z() <= 0.0) continue;
    const Eigen::Vector2d pixel = initial.camera.project(point);
    if (!initial.camera.contains(pixel)) continue;
    const float seen_px = initial.disparity_px(static_cast<int>(std::lround(pixel.x())),
                                               static_cast<int>(std::lround(pixel.y())));
    constexpr double tolerance_px = 0.5;
    free +=
        seen_px > 0.0F && static_cast<double>(seen_px) < initial.stereo.disparity_px(point.z()) + tolerance_px
            ? 1
            : 0;
  }
  return 2 * free >= target.pixels.size();
}

}  // namespace

std::vector<MovedTarget> moved_targets(const SimulatedCamera& final, const DepthView& initial,
                                       const Transform& initial_from_final) {
  const Intrinsics camera = final.info().depth;
  std::vector<MovedTarget> targets;
  for (Target& target : visible_targets(final)) {
    const bool big = is_big(final.scene(), target.kind);
    const bool seen_free = is_seen_free(target, camera, initial, initial_from_final);
    targets.push_back({std::move(target), big, seen_free});
  }
  return targets;
}

std::vector<Target> plain(const std::vector<MovedTarget>& targets) {
  std::vector<Target> result;
  for (const MovedTarget& target : targets) result.push_back(target.target);
  return result;
}

}  // namespace rva
