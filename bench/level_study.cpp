// Checks whether objects as high as the level of detection are found with the stated probability of 90 %.
//
// usage: rva_level_study exact|rest CAPTURES [INSPECTIONS [FIRST_SEED [CAMERAS [METHOD [WIDER_PX [TIMES]]]]]]
//
// In each bay, a final side in which nothing changed gives the level of detection. Boxes of TIMES that height
// are then placed on visible surfaces, and the final side is taken again. Each box has the material of the
// surface below it and the width to which the levels refer, plus WIDER_PX.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/arguments.hpp"
#include "core/intervals.hpp"
#include "core/random.hpp"
#include "detect/detect.hpp"
#include "evaluate/capture_room.hpp"
#include "evaluate/judgement.hpp"
#include "evaluate/moved_wing.hpp"
#include "evaluate/robot_side.hpp"
#include "scene/solids/shapes.hpp"
#include "sim/sensor/camera_models.hpp"

namespace {

using namespace rva;

struct StudyOptions {
  CameraReturn how = CameraReturn::exact;
  int captures = 1;
  int inspections = 20;
  std::uint64_t first_seed = 1;
  std::string cameras = "random:1";
  DetectionMethod method = DetectionMethod::automatic;
  int wider_px = 0;
  double times = 1.0;
};

struct Pixel {
  int u = 0;
  int v = 0;
};

/// One box, and whether it was found.
struct Trial {
  Pixel at;
  double level_mm = 0.0;
  double distance_m = 0.0;
  bool at_edge = false;
  bool found = false;
};

// Whether depth around a pixel varies by more than it would on a slope.
bool has_edge_around(const Image<float>& depth_m, Pixel at) {
  constexpr int around_px = 12;
  constexpr float jump = 0.06F;
  float least = depth_m(at.u, at.v);
  float most = least;
  for (int v = at.v - around_px; v <= at.v + around_px; ++v) {
    for (int u = at.u - around_px; u <= at.u + around_px; ++u) {
      if (depth_m(u, v) <= 0.0F) return true;
      least = std::min(least, depth_m(u, v));
      most = std::max(most, depth_m(u, v));
    }
  }
  return most > (1.0F + jump) * least;
}

// Random positions, far enough apart that no box helps the detection of another; every second one at an edge.
std::vector<Trial> chosen(const Image<float>& level_mm, const Image<float>& depth_m, std::uint64_t seed) {
  constexpr int boxes = 6;
  constexpr int tries = 4000;
  constexpr int apart_px = 70;
  constexpr int border_px = 30;
  constexpr float most_m = 1.2F;
  constexpr float most_level_mm = 60.0F;
  Random random(seed);
  std::vector<Trial> trials;
  for (int i = 0; i < tries && static_cast<int>(trials.size()) < boxes; ++i) {
    const Pixel at{static_cast<int>(random.uniform(border_px, level_mm.width() - border_px)),
                   static_cast<int>(random.uniform(border_px, level_mm.height() - border_px))};
    const float level = level_mm(at.u, at.v);
    const float distance_m = depth_m(at.u, at.v);
    const bool is_judged = level > 0.0F && level < most_level_mm && distance_m > 0.0F && distance_m < most_m;
    const bool is_apart = std::ranges::all_of(trials, [&](const Trial& other) {
      return std::hypot(other.at.u - at.u, other.at.v - at.v) > apart_px;
    });
    if (!is_judged || !is_apart) continue;
    const bool at_edge = has_edge_around(depth_m, at);
    if (at_edge == (trials.size() % 2 == 1)) trials.push_back({at, level, distance_m, at_edge, false});
  }
  return trials;
}

/// The trials of one bay, before and after the work.
class Bay {
 public:
  Bay(std::uint64_t seed, const StudyOptions& options, const StereoSensorOptions& sensor)
      : seed_(seed), options_(options), sensor_(sensor) {
    const MovedWing wing = random_moved_wing(mix(seed, 1), options.how);
    unchanged_ = wing.before;
    before_ = take(unchanged_, 1, "before");
    unchanged_.stand = wing.after.stand;
  }

  [[nodiscard]] std::vector<Trial> run() const {
    const RobotSide unchanged = take(unchanged_, 2, "unchanged");
    const Detection nothing = compare(unchanged);
    if (!nothing.level_of_detection) return {};
    const LevelOfDetection& level = *nothing.level_of_detection;
    const SimulatedCamera camera = camera_at(unchanged_, sensor_, unchanged.rested.front());
    const TrueView seen = camera.true_view();
    std::vector<Trial> trials = chosen(level.least_mm, seen.depth_m, mix(seed_, 4));
    Scene changed = unchanged_;
    for (const Trial& trial : trials)
      changed.objects.push_back(box_on(trial, level.summary.window_px + options_.wider_px, camera, seen));
    judge_all(changed, trials);
    return trials;
  }

 private:
  [[nodiscard]] RobotSide take(const Scene& scene, std::uint64_t stream, const char* folder) const {
    const double rest_error_deg = options_.how == CameraReturn::rest ? half_a_step_deg : 0.0;
    return take_by_robot(scene, sensor_, {.captures = options_.captures, .rest_error_deg = rest_error_deg},
                         mix(seed_, stream), room_.path() / folder);
  }

  [[nodiscard]] Detection compare(const RobotSide& after) const {
    DetectOptions options;
    options.method = options_.method;
    return detect(before_.open(options_.captures), after.open(options_.captures), options, {}).detection;
  }

  // A box with one face towards the camera that extends into the surface behind it.
  [[nodiscard]] SceneObject box_on(const Trial& trial, int width_px, const SimulatedCamera& camera,
                                   const TrueView& seen) const {
    constexpr double m_per_mm = 0.001;
    const Intrinsics& depth = camera.info().depth;
    const double width_m = width_px * trial.distance_m / depth.fx;
    const double height_m = options_.times * m_per_mm * trial.level_mm;
    const double long_m = height_m + width_m;
    const auto label = static_cast<std::size_t>(seen.labels(trial.at.u, trial.at.v));
    SceneObject object;
    object.name = fmt::format("box-{}-{}", trial.at.u, trial.at.v);
    object.kind = "box";
    object.role = Role::debris;
    object.parts.push_back(
        {box({width_m, width_m, long_m}), unchanged_.objects.at(label - 1).parts.front().material});
    const Eigen::Vector2d pixel(trial.at.u, trial.at.v);
    object.world_from_object =
        camera.world_from_camera() *
        Eigen::Translation3d(depth.deproject(pixel, trial.distance_m - height_m + 0.5 * long_m));
    return object;
  }

  void judge_all(const Scene& changed, std::vector<Trial>& trials) const {
    const RobotSide after = take(changed, 3, "changed");
    const std::vector<Target> targets = visible_targets(camera_at(changed, sensor_, after.rested.front()));
    const Detection detection = compare(after);
    const int width = detection.final_m.width();
    const Judgement judgement =
        judge(detection.findings.findings, targets, width, detection.final_m.height());
    for (Trial& trial : trials) {
      // The robot may come to rest slightly off, so that the box is not at exactly the same pixel.
      constexpr int shifted_px = 8;
      const auto is_there = [&](std::uint32_t i) {
        return std::abs(static_cast<int>(i) % width - trial.at.u) <= shifted_px &&
               std::abs(static_cast<int>(i) / width - trial.at.v) <= shifted_px;
      };
      for (std::size_t t = 0; t < targets.size(); ++t) {
        if (judgement.found[t] && std::ranges::any_of(targets[t].pixels, is_there)) trial.found = true;
      }
    }
  }

  std::uint64_t seed_;
  const StudyOptions& options_;
  StereoSensorOptions sensor_;
  CaptureRoom room_;
  Scene unchanged_;
  RobotSide before_;
};

void print(const std::string& name, const std::vector<Trial>& trials, const auto& belongs) {
  std::size_t found = 0;
  std::vector<double> levels_mm;
  for (const Trial& trial : trials) {
    if (!belongs(trial)) continue;
    found += trial.found ? 1U : 0U;
    levels_mm.push_back(trial.level_mm);
  }
  if (levels_mm.empty()) return;
  std::ranges::sort(levels_mm);
  const std::size_t count = levels_mm.size();
  const Interval share = share_interval(found, count);
  fmt::print("{:16} {:4} of {:4} found, {:.0f} % ({:.0f} to {:.0f} %); median level {:.1f} mm\n", name, found,
             count, 100.0 * static_cast<double>(found) / static_cast<double>(count), 100.0 * share.low,
             100.0 * share.high, levels_mm[count / 2]);
}

void study(const StudyOptions& options) {
  const auto sensor_of = camera_of_each(options.cameras);
  std::vector<Trial> trials;
  for (int i = 0; i < options.inspections; ++i) {
    const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(i);
    try {
      for (const Trial& trial : Bay(seed, options, sensor_of(seed)).run()) trials.push_back(trial);
    } catch (const RegistrationRefused& refused) {
      fmt::print(stderr, "bay {}: {}\n", seed, refused.problem());
    }
    fmt::print(stderr, "bay {} done, {} boxes\n", seed, trials.size());
  }
  print("all", trials, [](const Trial&) { return true; });
  print("away from edges", trials, [](const Trial& trial) { return !trial.at_edge; });
  print("at edges", trials, [](const Trial& trial) { return trial.at_edge; });
  for (const auto& [from_m, to_m] : {std::pair(0.0, 0.4), std::pair(0.4, 0.6), std::pair(0.6, 1.2)})
    print(fmt::format("{} to {} m", from_m, to_m), trials,
          [&](const Trial& trial) { return trial.distance_m >= from_m && trial.distance_m < to_m; });
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments(argc, argv);
  try {
    const auto method = value_of<DetectionMethod>(arguments.at(5, "auto"));
    if (arguments.count() >= 2 && arguments.count() <= 8 && method &&
        (arguments.at(0) == "exact" || arguments.at(0) == "rest")) {
      study({.how = arguments.at(0) == "rest" ? CameraReturn::rest : CameraReturn::exact,
             .captures = std::stoi(arguments.at(1)),
             .inspections = std::stoi(arguments.at(2, "20")),
             .first_seed = std::stoull(arguments.at(3, "1")),
             .cameras = arguments.at(4, "random:1"),
             .method = *method,
             .wider_px = std::stoi(arguments.at(6, "0")),
             .times = std::stod(arguments.at(7, "1"))});
      return 0;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "rva_level_study: {}\n", error.what());
    return 2;
  }
  fmt::print(stderr,
             "usage: rva_level_study exact|rest CAPTURES [INSPECTIONS [FIRST_SEED [CAMERAS [METHOD [WIDER_PX "
             "[TIMES]]]]]]\n");
  return 2;
}
