#include "evaluate/moved_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cloud/fused_view.hpp"
#include "cloud/registration.hpp"
#include "cloud/spatial_comparison.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "detect/findings.hpp"
#include "evaluate/moved_wing.hpp"
#include "robot/dither.hpp"

namespace rva {
namespace {

constexpr double join_px = 9.0;  // as in the study of a camera that did not move
constexpr std::array allowed_settings{0.001, 0.05, 0.5, 5.0};

/// Dithered captures of one scene, as far as they have been taken.
class Side {
 public:
  Side(Scene scene, std::uint64_t seed, int frames)
      : scene_(std::move(scene)), seed_(seed), frames_(frames), offsets_(dither_offsets(most_dithers)) {}

  void up_to(int captures) {
    while (views_.size() < static_cast<std::size_t>(captures)) take();
  }
  [[nodiscard]] DepthView fused() const { return fuse(views_); }
  [[nodiscard]] const DepthView& first() const { return views_.front().view; }
  [[nodiscard]] double unit_m() const { return unit_m_; }
  [[nodiscard]] Transform world_from_camera() const { return world_from_first_; }
  [[nodiscard]] SimulatedCamera camera(std::size_t number) const {
    Scene scene = scene_;
    scene.stand.pan_deg += offsets_[number].pan_deg;
    scene.stand.tilt_deg += offsets_[number].tilt_deg;
    return {std::move(scene), StereoSensorOptions{}, mix(seed_, number), ColorFrames::none};
  }

 private:
  void take() {
    SimulatedCamera camera = this->camera(views_.size());
    const CaptureInfo info = camera.info();
    DepthStatistics statistics(info.depth.width, info.depth.height);
    for (int i = 0; i < frames_; ++i) statistics.add(camera.wait_for_frame()->depth);
    unit_m_ = info.depth_unit_m;
    if (views_.empty()) world_from_first_ = camera.world_from_camera();
    views_.push_back({depth_view(statistics, info.depth, info.depth_unit_m,
                                 info.depth.fx * info.camera->baseline_m.value()),
                      world_from_first_.inverse() * camera.world_from_camera()});
  }

  Scene scene_;
  std::uint64_t seed_;
  int frames_;
  std::vector<PanTilt> offsets_;
  std::vector<PlacedView> views_;
  double unit_m_ = 0.0;
  Transform world_from_first_ = Transform::Identity();
};

bool is_big(const Scene& scene, const std::string& kind) {
  const auto object = std::ranges::find_if(scene.objects, [&](const SceneObject& candidate) {
    return candidate.role == Role::debris && candidate.kind == kind;
  });
  if (object == scene.objects.end()) return false;
  Eigen::Vector3d sides_m = size_m(*object);
  std::sort(sides_m.begin(), sides_m.end());
  return sides_m[0] >= 0.010 && sides_m[1] >= 0.015;
}

// Half of its pixels lie where the initial view has a surface, and before it.
bool is_seen_free(const Target& target, const Side& initial, const Side& final) {
  const Transform initial_from_final = initial.world_from_camera().inverse() * final.world_from_camera();
  const DepthView& view = initial.first();
  std::size_t free = 0;
  for (const std::uint32_t i : target.pixels) {
    const auto width = static_cast<std::uint32_t>(view.camera.width);
    const Eigen::Vector3d point =
        initial_from_final * final.first().camera.deproject({i % width, i / width}, target.distance_m);
    if (point.z() <= 0.0) continue;
    const Eigen::Vector2d pixel = view.camera.project(point);
    if (!view.camera.contains(pixel)) continue;
    const float seen_px =
        view.disparity_px(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
    constexpr double tolerance_px = 0.5;
    free += seen_px > 0.0F && static_cast<double>(seen_px) < view.disparity_m_px / point.z() + tolerance_px
                ? 1
                : 0;
  }
  return 2 * free >= target.pixels.size();
}

std::vector<MovedTarget> targets_of(const MovedWing& wing, const Side& initial, const Side& final) {
  std::vector<MovedTarget> targets;
  for (Target& target : visible_targets(final.camera(0))) {
    const bool big = is_big(wing.after, target.kind);
    const bool seen_free = is_seen_free(target, initial, final);
    targets.push_back({std::move(target), big, seen_free});
  }
  return targets;
}

std::vector<Target> plain(const std::vector<MovedTarget>& targets) {
  std::vector<Target> result;
  for (const MovedTarget& target : targets) result.push_back(target.target);
  return result;
}

MovedRegistration outcome_of(const Registration& registration, const Transform& truth, int captures) {
  const Transform off = truth.inverse() * registration.initial_from_final;
  return {captures, 1000.0 * off.translation().norm(),
          Eigen::AngleAxisd(off.linear()).angle() * 180.0 / std::numbers::pi, registration.doubt};
}

std::vector<Finding> find(const DepthView& initial, const DepthView& final, const Registration& registration,
                          double unit_m, double allowed) {
  if (!registration.trusted()) return {};
  const Comparison comparison = compare_spatial(change_from_elsewhere(initial, final, registration), unit_m,
                                                {.false_findings = allowed})
                                    .comparison;
  return measure_regions(find_regions(comparison.changed, {.join_px = join_px}), comparison, final.camera);
}

void inspect(int captures, const Side& before, const Side& unchanged, const Side& changed,
             MovedInspection& inspection) {
  const DepthView initial = before.fused();
  const DepthView clean = unchanged.fused();
  const DepthView final = changed.fused();
  const Registration of_clean = register_views(initial, clean);
  const Registration of_final = register_views(initial, final);
  const Transform truth = before.world_from_camera().inverse() * changed.world_from_camera();
  inspection.registrations.push_back(outcome_of(of_clean, truth, captures));
  inspection.registrations.push_back(outcome_of(of_final, truth, captures));
  for (const double allowed : allowed_settings) {
    const Judgement judgement = judge(find(initial, final, of_final, changed.unit_m(), allowed),
                                      plain(inspection.targets), final.camera.width, final.camera.height);
    inspection.results.push_back({captures, allowed,
                                  find(initial, clean, of_clean, unchanged.unit_m(), allowed).size(),
                                  judgement.false_findings, judgement.found});
  }
}

MovedInspection inspect(const MovedStudyOptions& options, std::uint64_t seed) {
  const MovedWing wing = random_moved_wing(seed);
  Scene clean = wing.after;
  std::erase_if(clean.objects, [](const SceneObject& object) { return object.role == Role::debris; });
  Side before(wing.before, mix(seed, 1), options.frames);
  Side unchanged(clean, mix(seed, 2), options.frames);
  Side changed(wing.after, mix(seed, 3), options.frames);
  MovedInspection inspection;
  inspection.seed = seed;
  for (const int captures : options.captures) {
    for (Side* side : {&before, &unchanged, &changed}) side->up_to(captures);
    if (inspection.targets.empty()) {
      const Transform move = before.world_from_camera().inverse() * changed.world_from_camera();
      inspection.move_m = move.translation().norm();
      inspection.turn_deg = Eigen::AngleAxisd(move.linear()).angle() * 180.0 / std::numbers::pi;
      inspection.targets = targets_of(wing, before, changed);
    }
    inspect(captures, before, unchanged, changed, inspection);
  }
  return inspection;
}

void check(const MovedStudyOptions& options) {
  const bool ascending = std::ranges::is_sorted(options.captures, std::less_equal{});
  const bool in_range =
      !options.captures.empty() && options.captures.front() >= 1 && options.captures.back() <= most_dithers;
  if (!ascending || !in_range)
    throw UsageError("--captures", "needs numbers from 1 to 16, each larger than the one before",
                     "give for example 1,4,8");
}

}  // namespace

std::vector<MovedInspection> run_moved_study(
    const MovedStudyOptions& options, const Progress& progress,
    const std::function<void(const std::vector<MovedInspection>&)>& keep) {
  check(options);
  std::vector<MovedInspection> done;
  const auto total = static_cast<std::size_t>(options.inspections);
  for (std::size_t i = 0; i < total; ++i) {
    done.push_back(inspect(options, options.first_seed + i));
    if (keep) keep(done);
    if (progress) progress("inspections", i + 1, total);
  }
  return done;
}

}  // namespace rva
