#include "evaluate/robot_study.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <system_error>

#include "cloud/detect.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "evaluate/moved_wing.hpp"
#include "evaluate/robot_side.hpp"
#include "sim/sensor/camera_models.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr std::array allowed_settings{0.05, 0.5};

/// For the captures of one inspection, gone afterwards.
class CaptureRoom {
 public:
  CaptureRoom() {
    std::string name = fs::temp_directory_path() / "rva-evaluate-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr)
      throw Error("captures", "have no room in the folder for temporary files",
                  "set TMPDIR to one that can be written");
    path_ = name;
  }
  ~CaptureRoom() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  CaptureRoom(const CaptureRoom&) = delete;
  CaptureRoom& operator=(const CaptureRoom&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

struct Sides {
  RobotSide before;
  RobotSide unchanged;
  RobotSide changed;
};

Sides take_sides(const MovedStudyOptions& options, const MovedWing& wing, const StereoSensorOptions& sensor,
                 std::uint64_t seed, const fs::path& room) {
  Scene clean = wing.after;
  std::erase_if(clean.objects, [](const SceneObject& object) { return object.role == Role::debris; });
  const int most = options.captures.back();
  return {take_by_robot(wing.before, sensor, most, options.frames, mix(seed, 1), room / "before"),
          take_by_robot(clean, sensor, most, options.frames, mix(seed, 2), room / "unchanged"),
          take_by_robot(wing.after, sensor, most, options.frames, mix(seed, 3), room / "changed")};
}

DepthView view_of(const Capture& capture) {
  const CaptureInfo& info = capture.info();
  DepthStatistics statistics(info.depth.width, info.depth.height);
  for (std::size_t i = 0; i < capture.depth_frames(); ++i) statistics.add(capture.depth(i));
  return depth_view(statistics, info.depth, info.depth_unit_m, disparity_m_px(info));
}

SidesDetection compare(const RobotSide& before, const RobotSide& after, int captures, double allowed) {
  DetectOptions options;
  options.static_camera.calibrated.false_findings = allowed;
  return detect(before.open(captures), after.open(captures), options, {});
}

MovedRegistration registration_of(const Registration& found, const Transform& final_from_initial,
                                  int captures) {
  const Transform off = final_from_initial * found.initial_from_final;
  return {"auto", captures, 1000.0 * off.translation().norm(),
          Eigen::AngleAxisd(off.linear()).angle() * 180.0 / std::numbers::pi, found.doubt};
}

/// Where a side's first camera really was.
Transform world_from_first(const Scene& scene, const StereoSensorOptions& sensor, const RobotSide& side) {
  return camera_at(scene, sensor, side.rested.front()).world_from_camera();
}

}  // namespace

MovedInspection inspect_by_robot(const MovedStudyOptions& options, std::uint64_t seed) {
  const CaptureRoom room;
  const MovedWing wing = random_moved_wing(seed, options.how);
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
  inspection.turn_deg = Eigen::AngleAxisd(initial_from_final.linear()).angle() * 180.0 / std::numbers::pi;
  inspection.targets = moved_targets(camera_at(wing.after, sensor, sides.changed.rested.front()),
                                     view_of(*sides.before.open(1).front()), initial_from_final);
  for (const int captures : options.captures) {
    for (const double allowed : allowed_settings) {
      const SidesDetection clean = compare(sides.before, sides.unchanged, captures, allowed);
      const SidesDetection littered = compare(sides.before, sides.changed, captures, allowed);
      if (allowed == allowed_settings.front()) {
        if (clean.registration)
          inspection.registrations.push_back(
              registration_of(*clean.registration, initial_from_unchanged.inverse(), captures));
        if (littered.registration)
          inspection.registrations.push_back(
              registration_of(*littered.registration, initial_from_final.inverse(), captures));
      }
      const auto& findings = littered.detection.findings.findings;
      const Judgement judgement =
          judge(findings, plain(inspection.targets), littered.detection.final_m.width(),
                littered.detection.final_m.height());
      inspection.results.push_back({"auto", captures, allowed, clean.detection.findings.findings.size(),
                                    judgement.false_findings, judgement.found});
    }
  }
  return inspection;
}

}  // namespace rva
