#include "evaluate/moved_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "cloud/octree_detection.hpp"
#include "cloud/registration.hpp"
#include "cloud/spatial_comparison.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "detect/findings.hpp"
#include "evaluate/dithered_side.hpp"
#include "evaluate/robot_study.hpp"
#include "sim/sensor/camera_models.hpp"

namespace rva {
namespace {

constexpr double join_px = 9.0;  // as in the study of a camera that did not move
constexpr std::array allowed_settings{0.001, 0.05, 0.5, 5.0};
constexpr std::array cells_m{0.02, 0.05, 0.1, 0.2};  // the thesis has 5 cm

Transform initial_from_final(const DitheredSide& initial, const DitheredSide& final) {
  return initial.world_from_camera().inverse() * final.world_from_camera();
}

MovedRegistration outcome_of(std::string method, int captures, const Transform& off, std::string doubt) {
  return {std::move(method), captures, 1000.0 * off.translation().norm(),
          Eigen::AngleAxisd(off.linear()).angle() * 180.0 / std::numbers::pi, std::move(doubt)};
}

std::vector<Finding> findings_of(const Comparison& comparison, const Intrinsics& camera) {
  return find_findings(comparison, {.join_px = join_px}, camera);
}

MovedResult result_of(std::string method, int captures, double setting, const std::vector<Finding>& clean,
                      const std::vector<Finding>& littered, const std::vector<MovedTarget>& targets,
                      const Intrinsics& camera) {
  const Judgement judgement = judge(littered, plain(targets), camera.width, camera.height);
  return {std::move(method), captures, setting, clean.size(), judgement.false_findings, judgement.found};
}

/// What changed since the side before; nothing where it cannot be known.
class Compared {
 public:
  Compared(CameraReturn how, const DitheredSide& initial, const DitheredSide& final) : final_(final) {
    if (how == CameraReturn::exact) {
      change_ =
          change_from_same_places(final.changes_since(initial), final.first().camera, final.disparity_m_px());
      return;
    }
    // A robot that stayed knows where it looks.
    const Transform known = initial_from_final(initial, final);
    const DepthView before = initial.fused();
    const DepthView after = final.fused();
    registration_ = how == CameraReturn::near ? register_views(before, after, {known, true})
                                              : register_views(before, after);
    if (registration_.trusted()) change_ = change_from_elsewhere(before, after, registration_);
  }

  [[nodiscard]] const Registration& registration() const { return registration_; }
  [[nodiscard]] std::vector<Finding> findings(double allowed) const {
    if (!change_) return {};
    return findings_of(compare_spatial(*change_, final_.unit_m(), {.false_findings = allowed}).comparison,
                       final_.first().camera);
  }

 private:
  const DitheredSide& final_;
  Registration registration_;
  std::optional<SpatialChange> change_;
};

void inspect(CameraReturn how, int captures, const DitheredSide& before, const DitheredSide& unchanged,
             const DitheredSide& changed, MovedInspection& inspection) {
  const Compared clean(how, before, unchanged);
  const Compared littered(how, before, changed);
  if (how != CameraReturn::exact) {
    const Transform final_from_initial = initial_from_final(before, changed).inverse();
    for (const Compared* compared : {&clean, &littered}) {
      const Registration& registration = compared->registration();
      inspection.registrations.push_back(outcome_of(
          "spatial", captures, final_from_initial * registration.initial_from_final, registration.doubt));
    }
  }
  for (const double allowed : allowed_settings)
    inspection.results.push_back(result_of("spatial", captures, allowed, clean.findings(allowed),
                                           littered.findings(allowed), inspection.targets,
                                           changed.first().camera));
}

// From the first frame of either side, as the thesis does it.
void inspect_by_octree(const DitheredSide& before, const DitheredSide& unchanged, const DitheredSide& changed,
                       MovedInspection& inspection) {
  const RegisteredClouds clean = register_clouds(before.first_frame(), unchanged.first_frame(), {}, {});
  const RegisteredClouds littered = register_clouds(before.first_frame(), changed.first_frame(), {}, {});
  const Transform truth = initial_from_final(before, changed);
  for (const RegisteredClouds* clouds : {&clean, &littered})
    inspection.registrations.push_back(outcome_of("octree", 1, truth * clouds->final_from_initial, ""));
  const Intrinsics& camera = changed.first().camera;
  for (const double cell_m : cells_m)
    inspection.results.push_back(result_of(
        "octree", 1, cell_m, findings_of(compare_clouds(clean, unchanged.first_frame(), cell_m), camera),
        findings_of(compare_clouds(littered, changed.first_frame(), cell_m), camera), inspection.targets,
        camera));
}

MovedInspection inspect(const MovedStudyOptions& options, std::uint64_t seed) {
  if (options.how == CameraReturn::rest) return inspect_by_robot(options, seed);
  const MovedWing wing = random_moved_wing(seed, options.how);
  const StereoSensorOptions sensor = options.sensor(seed);
  Scene clean = wing.after;
  std::erase_if(clean.objects, [](const SceneObject& object) { return object.role == Role::debris; });
  DitheredSide before(wing.before, sensor, mix(seed, 1), options.frames);
  DitheredSide unchanged(clean, sensor, mix(seed, 2), options.frames);
  DitheredSide changed(wing.after, sensor, mix(seed, 3), options.frames);
  MovedInspection inspection;
  inspection.seed = seed;
  inspection.matcher = name_of_matcher(sensor);
  inspection.ambient = wing.after.lighting.ambient;
  for (const int captures : options.captures) {
    for (DitheredSide* side : {&before, &unchanged, &changed}) side->up_to(captures);
    if (inspection.targets.empty()) {
      const Transform move = initial_from_final(before, changed);
      inspection.move_m = move.translation().norm();
      inspection.turn_deg = Eigen::AngleAxisd(move.linear()).angle() * 180.0 / std::numbers::pi;
      inspection.targets =
          moved_targets(changed.camera(0), before.first(), initial_from_final(before, changed));
    }
    inspect(options.how, captures, before, unchanged, changed, inspection);
  }
  if (options.octree) inspect_by_octree(before, unchanged, changed, inspection);
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
    const MovedStudyOptions& options, std::vector<MovedInspection> earlier, const Progress& progress,
    const std::function<void(const std::vector<MovedInspection>&)>& keep) {
  check(options);
  std::vector<MovedInspection> done = std::move(earlier);
  const auto total = static_cast<std::size_t>(options.inspections);
  if (done.size() > total) done.resize(total);
  for (std::size_t i = done.size(); i < total; ++i) {
    done.push_back(inspect(options, options.first_seed + i));
    if (keep) keep(done);
    if (progress) progress("inspections", i + 1, total);
  }
  return done;
}

}  // namespace rva
