// Compares what the baseline check states before the work with what the comparison after it would have found.
//
// usage: rva_promise_study FOLDER [INSPECTIONS [FIRST_SEED [CAMERAS [SCENE]]]]
//
// In each bay, a robot takes eight captures of a view and, as nothing changes, eight more after it returned.
// Prints the shares of the view in which objects of 5, 10 and 20 mm would be found and the median level of
// detection within 0.6 m, as expected from the baseline alone and as the comparison reaches them. Captures
// are kept in FOLDER and used again.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/arguments.hpp"
#include "core/quantile.hpp"
#include "core/random.hpp"
#include "detect/detect.hpp"
#include "detect/result_folder.hpp"
#include "evaluate/moved_wing.hpp"
#include "evaluate/robot_side.hpp"
#include "inspect/baseline_check.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/sensor/camera_models.hpp"

namespace {

using namespace rva;
namespace fs = std::filesystem;

constexpr int captures = 8;

/// What is stated of a view, before the work or after it.
struct Stated {
  std::vector<FindableShare> findable;
  double median_mm = 0.0;  ///< level of detection within 0.6 m
  double judged = 0.0;
};

double median_within(const LevelOfDetection& level, const Image<float>& depth_m) {
  constexpr float within_m = 0.6F;
  std::vector<float> levels_mm;
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    if (depth_m[i] < within_m && !std::isnan(level.least_mm[i])) levels_mm.push_back(level.least_mm[i]);
  }
  return levels_mm.empty() ? 0.0 : quantile(levels_mm, 0.5);
}

Stated stated_by(const Detection& detection, const Intrinsics& camera) {
  const DetectionLevelSummary summary = level_summary(detection, camera);
  return {summary.findable, median_within(*detection.level_of_detection, detection.final_m), summary.judged};
}

// A folder of captures that is complete is named so at last.
RobotSide taken(const Scene& scene, const StereoSensorOptions& sensor, std::uint64_t seed,
                const fs::path& folder) {
  if (!fs::exists(folder)) {
    const fs::path partial = folder.string() + ".partial";
    fs::remove_all(partial);
    static_cast<void>(take_by_robot(scene, sensor, {.captures = captures, .rest_error_deg = half_a_step_deg},
                                    seed, partial));
    fs::rename(partial, folder);
  }
  RobotSide side;
  for (const fs::directory_entry& capture : fs::directory_iterator(folder))
    side.captures.push_back(capture.path());
  std::ranges::sort(side.captures);
  return side;
}

void print(const std::string& name, const Stated& expected, const Stated& reached) {
  fmt::print("{}: ", name);
  for (std::size_t k = 0; k < reached.findable.size(); ++k)
    fmt::print("{:2} mm {:4.1f} % of {:4.1f} %, ", reached.findable[k].size_mm,
               100.0 * expected.findable[k].share, 100.0 * reached.findable[k].share);
  fmt::print("median {:.2f} of {:.2f} mm = {:.2f}; judged {:.2f} of {:.2f}\n", expected.median_mm,
             reached.median_mm, expected.median_mm / reached.median_mm, expected.judged, reached.judged);
  std::fflush(stdout);
}

void study(const fs::path& room, int inspections, std::uint64_t first_seed, const std::string& cameras,
           const std::string& scene) {
  const auto sensor_of = camera_of_each(cameras);
  for (int i = 0; i < inspections; ++i) {
    const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
    const Scene bay = scene.empty() ? random_moved_wing(mix(seed, 1), CameraReturn::rest).before
                                    : load_scene(scene, {.no_debris = true});
    const fs::path folder =
        room / fmt::format("{}-{}", scene.empty() ? "random" : fs::path(scene).stem().string(), seed);
    fs::create_directories(folder);
    const RobotSide before = taken(bay, sensor_of(seed), mix(seed, 1), folder / "before");
    const RobotSide after = taken(bay, sensor_of(seed), mix(seed, 2), folder / "after");
    const Captures initial = before.open(captures);
    const Captures final = after.open(captures);
    const Intrinsics& camera = final.front()->info().depth;
    print(folder.filename(), stated_by(expected_detection(before.open(captures), {}), camera),
          stated_by(detect(initial, final, {}, {}).detection, camera));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments(argc, argv);
  try {
    if (arguments.count() >= 1 && arguments.count() <= 5) {
      study(arguments.at(0), std::stoi(arguments.at(1, "8")), std::stoull(arguments.at(2, "1510001")),
            arguments.at(3, "random:1"), arguments.at(4));
      return 0;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "rva_promise_study: {}\n", error.what());
    return 2;
  }
  fmt::print(stderr, "usage: rva_promise_study FOLDER [INSPECTIONS [FIRST_SEED [CAMERAS [SCENE]]]]\n");
  return 2;
}
