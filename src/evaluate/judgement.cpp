#include "evaluate/judgement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>

#include "depth/mat_view.hpp"
#include "sim/sensor/trace_light.hpp"

namespace rva {
namespace {

Mask grown(Mask mask, int by_px) {
  cv::Mat pixels = as_mat(mask);
  cv::dilate(pixels, pixels, cv::Mat::ones(2 * by_px + 1, 2 * by_px + 1, CV_8U));
  return mask;
}

Mask mask_of(const std::vector<std::uint32_t>& pixels, int width, int height) {
  Mask mask(width, height);
  for (const std::uint32_t i : pixels) mask[i] = mask_set;
  return mask;
}

bool touches(const Finding& finding, const Mask& mask) {
  return std::ranges::any_of(finding.pixels, [&](std::uint32_t i) { return mask[i] != 0; });
}

// Whether at least half of the finding's pixels are in the mask.
bool lies_in(const Finding& finding, const Mask& mask) {
  const auto inside = std::ranges::count_if(finding.pixels, [&](std::uint32_t i) { return mask[i] != 0; });
  return 2 * static_cast<std::size_t>(inside) >= finding.pixels.size();
}

// The number of pixels that would see the object if the scene contained nothing else.
int pixels_alone(const SimulatedCamera& camera, std::size_t object) {
  const RayCaster alone(camera.scene(), std::array{object});
  const Transform world_from_camera = camera.world_from_camera();
  const Intrinsics imager = camera.info().depth;
  const Eigen::Vector3f origin = world_from_camera.translation().cast<float>();
  std::vector<Ray> rays(static_cast<std::size_t>(imager.width));
  std::vector<std::uint8_t> met(rays.size());
  constexpr float far_m = 100.0F;
  std::ptrdiff_t pixels = 0;
  for (int v = 0; v < imager.height; ++v) {
    for (int u = 0; u < imager.width; ++u) {
      const Eigen::Vector3d direction = world_from_camera.rotation() * imager.deproject({u, v}, 1.0);
      rays[static_cast<std::size_t>(u)] = {origin, far_m * direction.cast<float>()};
    }
    alone.occluded(rays, met);
    pixels += std::ranges::count(met, 1);
  }
  return static_cast<int>(pixels);
}

std::vector<std::uint32_t> work_pixels(const SimulatedCamera& before, const SimulatedCamera& after) {
  std::vector<std::uint32_t> pixels;
  const auto add = [&pixels](const SimulatedCamera& camera, const auto& is_work) {
    const std::vector<SceneObject>& objects = camera.scene().objects;
    if (std::ranges::none_of(objects, is_work)) return;
    const TrueView view = camera.true_view();
    for (std::size_t i = 0; i < view.labels.size(); ++i) {
      if (view.labels[i] > 0 && is_work(objects[view.labels[i] - 1U]))
        pixels.push_back(static_cast<std::uint32_t>(i));
    }
  };
  add(after, [](const SceneObject& object) { return object.role == Role::work; });
  add(before, [&after](const SceneObject& object) {
    return std::ranges::find(after.scene().objects, object.name, &SceneObject::name) ==
           after.scene().objects.end();
  });
  return pixels;
}

std::vector<std::uint32_t> trace_pixels(const SimulatedCamera& after) {
  constexpr float least_change = 0.01F;
  std::vector<std::uint32_t> pixels;
  if (after.scene().traces.empty()) return pixels;
  const TrueView view = after.true_view();
  const Intrinsics camera = after.info().depth;
  const Transform world_from_camera = after.world_from_camera();
  for (int v = 0; v < view.depth_m.height(); ++v) {
    for (int u = 0; u < view.depth_m.width(); ++u) {
      const double depth_m = view.depth_m(u, v);
      if (depth_m <= 0.0) continue;
      const Eigen::Vector3d point = world_from_camera * camera.deproject(Eigen::Vector2d(u, v), depth_m);
      if (std::abs(trace_light(after.scene().traces, point.cast<float>()) - 1.0F) > least_change)
        pixels.push_back(static_cast<std::uint32_t>(v * view.depth_m.width() + u));
    }
  }
  return pixels;
}

}  // namespace

std::vector<Target> visible_targets(const SimulatedCamera& camera) {
  const TrueView view = camera.true_view();
  const std::vector<SceneObject>& objects = camera.scene().objects;
  std::vector<Target> targets;
  for (std::size_t object = 0; object < objects.size(); ++object) {
    if (objects[object].role != Role::debris) continue;
    Target target{.kind = objects[object].kind, .pixels = {}};
    for (std::size_t i = 0; i < view.labels.size(); ++i) {
      if (view.labels[i] != Scene::label_of(object)) continue;
      target.pixels.push_back(static_cast<std::uint32_t>(i));
      target.distance_m += static_cast<double>(view.depth_m[i]);
    }
    if (target.pixels.empty()) continue;
    target.visible_px = static_cast<int>(target.pixels.size());
    target.distance_m /= target.visible_px;
    target.unhidden_px = pixels_alone(camera, object);
    targets.push_back(std::move(target));
  }
  return targets;
}

OtherChanges other_changes(const SimulatedCamera& before, const SimulatedCamera& after) {
  return {work_pixels(before, after), trace_pixels(after)};
}

void count_shown(const DepthStatistics& without, const DepthStatistics& with, const StereoScale& stereo,
                 std::vector<Target>& targets) {
  constexpr double trace_px = 0.1;
  const double product_units_px = stereo.focal_baseline_units_px();
  const auto shows = [&](std::size_t i) {
    if (without.seen(i) != with.seen(i)) return true;
    if (!with.seen(i)) return false;
    return std::abs(product_units_px / with.mean(i) - product_units_px / without.mean(i)) > trace_px;
  };
  for (Target& target : targets) {
    const Mask around = grown(mask_of(target.pixels, with.width(), with.height()), found_within_px);
    target.shown_px = 0;
    for (std::size_t i = 0; i < around.size(); ++i) target.shown_px += around[i] != 0 && shows(i) ? 1 : 0;
  }
}

Judgement judge(const std::vector<Finding>& findings, const std::vector<Target>& targets, int width,
                int height, const OtherChanges& others) {
  Mask any(width, height);
  for (const Target& target : targets) {
    for (const std::uint32_t i : target.pixels) any[i] = mask_set;
  }
  const Mask near_debris = grown(std::move(any), near_target_px);
  const Mask near_work = grown(mask_of(others.work, width, height), near_target_px);
  const Mask near_traces = grown(mask_of(others.traces, width, height), near_target_px);
  Judgement judgement;
  std::vector<const Finding*> pointing;
  for (const Finding& finding : findings) {
    if (lies_in(finding, near_debris))
      pointing.push_back(&finding);
    else if (lies_in(finding, near_work))
      ++judgement.work_findings;
    else
      ++(lies_in(finding, near_traces) ? judgement.trace_findings : judgement.false_findings);
  }
  for (const Target& target : targets) {
    const Mask around = grown(mask_of(target.pixels, width, height), found_within_px);
    judgement.found.push_back(
        std::ranges::any_of(pointing, [&](const Finding* finding) { return touches(*finding, around); }));
  }
  return judgement;
}

}  // namespace rva
