#include "evaluate/moved_inspection.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "core/units.hpp"
#include "detect/detect.hpp"
#include "detect/findings/findings.hpp"
#include "detect/thesis/octree_detection.hpp"
#include "evaluate/capture_room.hpp"
#include "evaluate/judgement.hpp"
#include "evaluate/moved_wing.hpp"
#include "evaluate/robot_side.hpp"
#include "geometry/rigid_motion.hpp"
#include "sim/sensor/camera_models.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr std::array cells_m{0.02, 0.05, 0.1, 0.2};  // the thesis has 5 cm
constexpr double join_px = 9.0;                      // of the thesis' findings: as in the static study

struct Sides {
  RobotSide before;
  RobotSide unchanged;
  RobotSide changed;
};

Sides take_sides(const MovedStudyOptions& options, const MovedWing& wing, const StereoSensorOptions& sensor,
                 std::uint64_t seed, const fs::path& room) {
  Scene unchanged = wing.before;
  unchanged.stand = wing.after.stand;
  const RobotSideOptions before{.captures = options.captures.back(),
                                .frames = options.frames,
                                .rest_error_deg = options.how == CameraReturn::rest ? half_a_step_deg : 0.0,
                                .lamp = options.lamp,
                                .color = options.color};
  RobotSideOptions after = before;
  if (options.how == CameraReturn::rest)
    after.baseline =
        Baseline{room / "before", static_cast<std::size_t>(before.captures), options.pose_return};
  return {take_by_robot(wing.before, sensor, before, mix(seed, 1), room / "before"),
          take_by_robot(unchanged, sensor, after, mix(seed, 2), room / "unchanged"),
          take_by_robot(wing.after, sensor, after, mix(seed, 3), room / "changed")};
}

/// What a comparison came to; a refused one finds nothing, neither debris nor anything false.
struct Compared {
  std::vector<Finding> findings;
  std::optional<Registration> registration;
  std::string refused;  ///< why; empty where it was not
};

Compared compare(const RobotSide& before, const RobotSide& after, int captures, double allowed) {
  DetectOptions options;
  options.static_camera.calibrated.false_findings = allowed;
  try {
    SidesDetection found = detect(before.open(captures), after.open(captures), options, {});
    return {std::move(found.detection.findings.findings), std::move(found.registration), {}};
  } catch (const RegistrationRefused& refused) {
    return {{}, {}, refused.problem()};
  }
}

double turn_deg(const Transform& motion) { return angle_deg_of(motion); }

MovedRegistration error_of(std::string method, int captures, const Transform& off) {
  return {.method = std::move(method),
          .captures = captures,
          .error_mm = mm_per_m * off.translation().norm(),
          .error_deg = turn_deg(off),
          .doubt = {}};
}

// Compares the error, a small motion in the initial camera's frame, with the covariance. The result is empty
// where the images show that the camera came back exactly, because no covariance is stated then.
std::optional<double> normalised(const Registration& found, const Transform& off) {
  if (found.covariance.isZero()) return std::nullopt;
  const Twist error = log_of(off);
  return error.dot(found.covariance.ldlt().solve(error));
}

void note_error(const Compared& compared, const Transform& final_from_initial, int captures,
                MovedInspection& inspection) {
  if (!compared.refused.empty())
    inspection.registrations.push_back({.method = "auto", .captures = captures, .doubt = compared.refused});
  if (!compared.registration) return;
  const Transform& found = compared.registration->initial_from_final;
  inspection.registrations.push_back(error_of("auto", captures, final_from_initial * found));
  inspection.registrations.back().normalised = normalised(*compared.registration, found * final_from_initial);
}

MovedResult result_of(std::string method, int captures, double setting, std::size_t false_when_clean,
                      const Judgement& judgement) {
  return {.method = std::move(method),
          .captures = captures,
          .setting = setting,
          .false_when_clean = false_when_clean,
          .false_with_debris = judgement.false_findings,
          .work_findings = judgement.work_findings,
          .trace_findings = judgement.trace_findings,
          .found = judgement.found};
}

/// The first depth image of a side, as the thesis takes it.
struct FirstFrame {
  explicit FirstFrame(const Capture& capture) : info(capture.info()), depth(capture.depth(0)) {}
  [[nodiscard]] DepthFrame frame() const { return {depth, info}; }
  CaptureInfo info;
  DepthImage depth;
};

void inspect_by_octree(const Sides& sides, const Transform& initial_from_final, const OtherChanges& others,
                       MovedInspection& inspection) {
  const FirstFrame before(*sides.before.open(1).front());
  const FirstFrame unchanged(*sides.unchanged.open(1).front());
  const FirstFrame changed(*sides.changed.open(1).front());
  const RegisteredClouds clean = register_clouds(before.frame(), unchanged.frame(), {}, {});
  const RegisteredClouds littered = register_clouds(before.frame(), changed.frame(), {}, {});
  for (const RegisteredClouds* clouds : {&clean, &littered})
    inspection.registrations.push_back(
        error_of("octree", 1, initial_from_final * clouds->final_from_initial));
  const Intrinsics& camera = changed.info.depth;
  const auto findings = [&](const RegisteredClouds& clouds, const FirstFrame& final, double cell_m) {
    return find_findings(compare_clouds(clouds, final.frame(), cell_m), {.join_px = join_px}, camera);
  };
  for (const double cell_m : cells_m)
    inspection.results.push_back(
        result_of("octree", 1, cell_m, findings(clean, unchanged, cell_m).size(),
                  judge(findings(littered, changed, cell_m), plain(inspection.targets), camera.width,
                        camera.height, others)));
}

// Where a side's first camera really was.
Transform world_from_first(const Scene& scene, const StereoSensorOptions& sensor, const RobotSide& side) {
  return camera_at(scene, sensor, side.rested.front()).world_from_camera();
}

void state_return(const Sides& sides, MovedInspection& inspection) {
  const auto captures = sides.changed.captures.size();
  inspection.approaches = 0.0;
  for (const auto& capture : sides.changed.open(static_cast<int>(captures)))
    inspection.approaches += capture->info().pose.value_or(Pose{}).approaches.value_or(1);
  for (std::size_t k = 0; k < captures; ++k)
    inspection.off_baseline_deg +=
        std::hypot(sides.changed.rested[k].pan_deg - sides.before.rested[k].pan_deg,
                   sides.changed.rested[k].tilt_deg - sides.before.rested[k].tilt_deg);
  inspection.approaches /= static_cast<double>(captures);
  inspection.off_baseline_deg /= static_cast<double>(captures);
}

}  // namespace

MovedInspection inspect_moved(const MovedStudyOptions& options, std::uint64_t seed) {
  const CaptureRoom room;
  const MovedWing wing = random_moved_wing(seed, options.how, options.bay);
  const StereoSensorOptions sensor = options.sensor(seed);
  const Sides sides = take_sides(options, wing, sensor, seed, room.path());
  const Transform initial_from_world = world_from_first(wing.before, sensor, sides.before).inverse();
  const Transform initial_from_final =
      initial_from_world * world_from_first(wing.after, sensor, sides.changed);
  const Transform initial_from_unchanged =
      initial_from_world * world_from_first(wing.after, sensor, sides.unchanged);
  MovedInspection inspection;
  inspection.seed = seed;
  inspection.matcher = name_of_matcher(sensor);
  inspection.ambient = wing.after.lighting.ambient;
  inspection.move_m = initial_from_final.translation().norm();
  inspection.turn_deg = turn_deg(initial_from_final);
  if (options.how == CameraReturn::rest) state_return(sides, inspection);
  inspection.targets = moved_targets(camera_at(wing.after, sensor, sides.changed.rested.front()),
                                     depth_view(*sides.before.open(1).front()), initial_from_final);
  Scene before = wing.before;
  before.stand = wing.after.stand;
  const OtherChanges others = other_changes(camera_at(before, sensor, sides.changed.rested.front()),
                                            camera_at(wing.after, sensor, sides.changed.rested.front()));
  const Intrinsics camera = sides.changed.open(1).front()->info().depth;
  for (const int captures : options.captures) {
    for (const double allowed : options.allowed) {
      const Compared clean = compare(sides.before, sides.unchanged, captures, allowed);
      const Compared littered = compare(sides.before, sides.changed, captures, allowed);
      if (allowed == options.allowed.front()) {
        note_error(clean, initial_from_unchanged.inverse(), captures, inspection);
        note_error(littered, initial_from_final.inverse(), captures, inspection);
      }
      const Judgement judgement =
          judge(littered.findings, plain(inspection.targets), camera.width, camera.height, others);
      inspection.results.push_back(result_of("auto", captures, allowed, clean.findings.size(), judgement));
    }
  }
  if (options.octree) inspect_by_octree(sides, initial_from_final, others, inspection);
  return inspection;
}

}  // namespace rva
