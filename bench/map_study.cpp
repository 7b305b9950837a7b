// Accuracy of maps of simulated bays and of the robot's calibration, against the truth.
//
// usage: rva_map_study FOLDER FIRST_SEED INSPECTIONS [map]
//
// Views are kept in FOLDER and not taken again. With `map`, the geometry is known and not calibrated.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bench/surface_distance.hpp"
#include "core/quantile.hpp"
#include "core/random.hpp"
#include "core/stopwatch.hpp"
#include "evaluate/random_wing.hpp"
#include "map/calibration.hpp"
#include "map/map_cloud.hpp"
#include "map/pose_refinement.hpp"
#include "map/view_capture.hpp"
#include "map/waypoints.hpp"
#include "scene/camera_stand.hpp"
#include "sim/simulated_camera.hpp"
#include "sim/simulated_robot.hpp"

namespace fs = std::filesystem;

namespace {

using namespace rva;

constexpr double deg_per_rad = 180.0 / std::numbers::pi;

Scene wing(std::uint64_t seed) {
  Scene scene = random_wing(seed);
  drop_debris(scene, seed);
  return scene;
}

/// Records the robot's true joint angles whenever info() is called.
class WatchedCamera : public Camera {
 public:
  WatchedCamera(SimulatedCamera& camera, SimulatedRobot& robot, std::vector<PanTilt>& truth)
      : camera_(camera), robot_(robot), truth_(truth) {}
  [[nodiscard]] CaptureInfo info() const override {
    truth_.push_back(robot_.true_joints());
    return camera_.info();
  }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override { return camera_.wait_for_frame(); }

 private:
  SimulatedCamera& camera_;
  SimulatedRobot& robot_;
  std::vector<PanTilt>& truth_;
};

std::vector<PanTilt> map_waypoints() { return load_waypoints(RVA_DATA_DIR "/waypoints/bay.json"); }
std::vector<PanTilt> calibration_waypoints() {
  return load_waypoints(RVA_DATA_DIR "/waypoints/calibrate.json");
}

// Takes views as `rva map` does, and writes the true joint angles to `truth.txt` beside them.
void take(const fs::path& folder, std::uint64_t seed, const std::vector<PanTilt>& waypoints) {
  if (fs::exists(folder / "truth.txt")) return;
  fs::create_directories(folder);
  const Clock clock = unhurried_clock();
  SimulatedRobotOptions options;
  options.rest_error_deg = 0.16;
  SimulatedRobot robot(options, clock.now_s, mix(seed, 0x5E7));
  SimulatedCamera camera(wing(seed), StereoSensorOptions{}, mix(seed, 0xCA3), ColorFrames::all,
                         [&robot] { return robot.true_joints(); });
  std::vector<PanTilt> truth;
  WatchedCamera watched(camera, robot, truth);
  const std::string base = "study";
  const PanTiltChain chain;
  take_views({watched, robot, clock, chain, base}, waypoints, folder, {}, {});
  std::ofstream file(folder / "truth.txt");
  for (std::size_t i = 1; i < truth.size(); ++i)  // the first call of info() precedes the first view
    file << fmt::format("{:.9f} {:.9f}\n", truth[i].pan_deg, truth[i].tilt_deg);
}

struct Bay {
  std::vector<MapView> views;
  std::vector<Transform> true_poses;
};

Bay load(const fs::path& folder) {
  Bay bay;
  std::ifstream file(folder / "truth.txt");
  PanTilt joints;
  for (std::size_t i = 0; file >> joints.pan_deg >> joints.tilt_deg; ++i) {
    bay.views.push_back(load_map_view(*open_capture(folder / view_name(i)), view_name(i)));
    bay.true_poses.push_back(foot_from_camera({}, joints));
  }
  return bay;
}

struct PoseErrors {
  std::vector<double> mm;
  std::vector<double> deg;

  void add(const Transform& pose, const Transform& truth) {
    const Transform error = truth.inverse() * pose;
    mm.push_back(1000.0 * error.translation().norm());
    deg.push_back(deg_per_rad * Eigen::AngleAxisd(error.linear()).angle());
  }
  [[nodiscard]] std::string summary() const {
    std::vector<double> a = mm;
    std::vector<double> b = deg;
    const auto within = [this] {
      int count = 0;
      for (std::size_t i = 0; i < mm.size(); ++i) count += mm[i] <= 1.5 && deg[i] <= 0.1 ? 1 : 0;
      return count;
    };
    return fmt::format(
        "median {:.2f} mm {:.3f} deg, worst {:.2f} mm {:.3f} deg, {} of {} within 1.5 mm and 0.1 deg",
        quantile(a, 0.5), quantile(b, 0.5), quantile(a, 1.0), quantile(b, 1.0), within(), mm.size());
  }
};

double rms_mm(const std::vector<MapPoint>& points, const Scene& scene, const SurfaceDistance& surfaces) {
  constexpr double most_m = 0.05;  // points farther off are wrong matches, regardless of the poses
  const Transform world_from_foot = rva::world_from_foot(scene.stand);
  double sum = 0.0;
  for (const MapPoint& point : points) {
    const double distance_m = surfaces.distance_m(world_from_foot * point.position_m.cast<double>(), most_m);
    sum += distance_m * distance_m;
  }
  return 1000.0 * std::sqrt(sum / static_cast<double>(points.size()));
}

std::vector<Transform> transforms(const std::vector<RefinedPose>& poses) {
  std::vector<Transform> result;
  for (const RefinedPose& pose : poses) result.push_back(pose.foot_from_camera);
  return result;
}

// A bracket measured by hand: off by 5 mm and 2 degrees in every parameter that calibration can determine.
PanTiltChain perturbed(std::uint64_t seed) {
  Random random(mix(seed, 0xBAD));
  const auto direction = [&random]() -> Eigen::Vector3d {
    return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
  };
  const auto sign = [&random] { return random.uniform() < 0.5 ? -1.0 : 1.0; };
  PanTiltChain chain;
  chain.bracket.at_m.y() += 0.005 * sign();
  chain.bracket.axis =
      Eigen::AngleAxisd(2.0 / deg_per_rad * sign(), Eigen::Vector3d::UnitY()) * chain.bracket.axis;
  chain.bracket_from_camera.translation() += 0.005 * direction();
  chain.bracket_from_camera.linear() =
      Eigen::AngleAxisd(2.0 / deg_per_rad, direction()) * chain.bracket_from_camera.linear();
  return chain;
}

struct GeometryErrors {
  double tilt_axis_mm, tilt_axis_deg, camera_mm, camera_deg;
  [[nodiscard]] bool good() const {
    return tilt_axis_mm <= 1.0 && camera_mm <= 1.0 && tilt_axis_deg <= 0.1 && camera_deg <= 0.1;
  }
};

GeometryErrors errors_of(const PanTiltChain& chain) {
  const PanTiltChain truth;
  const Transform camera = truth.bracket_from_camera.inverse() * chain.bracket_from_camera;
  return {1000.0 * (chain.bracket.at_m - truth.bracket.at_m).norm(),
          deg_per_rad * std::acos(std::min(1.0, chain.bracket.axis.dot(truth.bracket.axis))),
          1000.0 * camera.translation().norm(), deg_per_rad * Eigen::AngleAxisd(camera.linear()).angle()};
}

void print(const char* name, const GeometryErrors& errors) {
  fmt::print("  {}: tilt axis {:.2f} mm {:.3f} deg, camera {:.2f} mm {:.3f} deg\n", name, errors.tilt_axis_mm,
             errors.tilt_axis_deg, errors.camera_mm, errors.camera_deg);
}

/// Totals over all inspections.
struct Totals {
  PoseErrors by_joints;
  PoseErrors refined;
  PoseErrors refined_among_each_other;
  PoseErrors refined_by_calibration;
  std::vector<double> ratio_by_joints;
  std::vector<double> ratio_refined;
  PoseErrors worn_by_joints;
  PoseErrors worn_refined;
  int calibrated = 0;
  int within_two_sigma = 0;
  int lengths = 0;
};

void add(const std::vector<Transform>& poses, const std::vector<Transform>& truth, PoseErrors& errors) {
  for (std::size_t i = 0; i < poses.size(); ++i) errors.add(poses[i], truth[i]);
}

// Aligns the poses with the true ones by one rigid transform. Calibration cannot determine the frame of the
// foot, and a transform common to all views does not affect the quality of a map.
std::vector<Transform> put_onto(const std::vector<Transform>& truth, std::vector<Transform> poses) {
  Eigen::Vector4d turn = Eigen::Vector4d::Zero();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Transform between = truth[i] * poses[i].inverse();
    const Eigen::Vector4d quaternion = Eigen::Quaterniond(between.linear()).coeffs();
    turn += quaternion.w() < 0.0 ? Eigen::Vector4d(-quaternion) : quaternion;
  }
  Transform onto(Eigen::Quaterniond(turn.normalized()));
  for (std::size_t i = 0; i < poses.size(); ++i)
    shift += truth[i].translation() - onto * poses[i].translation();
  onto.pretranslate(shift / static_cast<double>(poses.size()));
  for (Transform& pose : poses) pose = onto * pose;
  return poses;
}

// The same robot without the approach from below: for joints that arrived from above, the true angle is 0.3
// degrees larger than the reported one.
std::vector<MapView> with_play(std::vector<MapView> views, std::uint64_t seed) {
  constexpr double play_deg = 0.3;
  Random random(mix(seed, 0x91A7));
  for (MapView& view : views) {
    if (random.uniform() < 0.5) view.joints.pan_deg -= play_deg;
    if (random.uniform() < 0.5) view.joints.tilt_deg -= play_deg;
  }
  return views;
}

// Counts for the four lengths whether the error is within two stated standard deviations.
void hold_to_deviations(const Calibration& calibration, Totals& totals) {
  const PanTiltChain truth;
  const Eigen::Vector3d camera_mm = 1000.0 * (calibration.chain.bracket_from_camera.translation() -
                                              truth.bracket_from_camera.translation());
  const double forward_mm = 1000.0 * (calibration.chain.bracket.at_m - truth.bracket.at_m).y();
  const std::array<std::pair<std::size_t, double>, 4> errors{
      {{0, forward_mm}, {2, camera_mm.x()}, {3, camera_mm.y()}, {4, camera_mm.z()}}};
  for (const auto& [number, error_mm] : errors) {
    ++totals.lengths;
    totals.within_two_sigma += std::abs(error_mm) <= 2.0 * calibration.numbers.at(number).deviation ? 1 : 0;
  }
}

Calibration study_calibration(const fs::path& folder, std::uint64_t seed, Totals& totals) {
  take(folder, seed, calibration_waypoints());
  const Bay bay = load(folder);
  const PanTiltChain given = perturbed(seed);
  const Stopwatch start;
  Calibration calibration = calibrate(bay.views, given);
  const double ms = start.ms();
  print("geometry given", errors_of(given));
  print("calibrated    ", errors_of(calibration.chain));
  fmt::print("  of {} views in {:.0f} ms {}\n", bay.views.size(), ms, calibration.doubt);
  hold_to_deviations(calibration, totals);
  totals.calibrated += errors_of(calibration.chain).good() ? 1 : 0;
  return calibration;
}

void study_map(const fs::path& folder, std::uint64_t seed, const PanTiltChain& calibrated, Totals& totals) {
  take(folder, seed, map_waypoints());
  const Bay bay = load(folder);
  const Scene scene = wing(seed);
  const SurfaceDistance surfaces(scene);
  std::vector<Transform> by_joints;
  for (const MapView& view : bay.views) by_joints.push_back(foot_from_camera({}, view.joints));
  const Stopwatch start;
  const std::vector<RefinedPose> poses = refine_poses(bay.views, {});
  const double refine_ms = start.ms();
  const std::vector<Transform> refined = transforms(poses);
  const std::vector<MapPoint> map = join_views(bay.views, refined, {});
  const double all_ms = start.ms();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i].doubt.empty()) fmt::print("  view {}: {}\n", i, poses[i].doubt);
  }
  const double perfect_mm = rms_mm(join_views(bay.views, bay.true_poses, {}), scene, surfaces);
  const double joints_mm = rms_mm(join_views(bay.views, by_joints, {}), scene, surfaces);
  const double refined_mm = rms_mm(map, scene, surfaces);
  totals.ratio_by_joints.push_back(joints_mm / perfect_mm);
  totals.ratio_refined.push_back(refined_mm / perfect_mm);
  PoseErrors errors;
  add(refined, bay.true_poses, errors);
  add(refined, bay.true_poses, totals.refined);
  add(put_onto(bay.true_poses, refined), bay.true_poses, totals.refined_among_each_other);
  add(by_joints, bay.true_poses, totals.by_joints);
  const std::vector<Transform> by_calibration = transforms(refine_poses(bay.views, calibrated));
  add(put_onto(bay.true_poses, by_calibration), bay.true_poses, totals.refined_by_calibration);
  const std::vector<MapView> worn = with_play(bay.views, seed);
  by_joints.clear();
  for (const MapView& view : worn) by_joints.push_back(foot_from_camera({}, view.joints));
  RefinementOptions options;
  options.servo_error_deg = 0.3;
  add(put_onto(bay.true_poses, by_joints), bay.true_poses, totals.worn_by_joints);
  add(put_onto(bay.true_poses, transforms(refine_poses(worn, {}, options))), bay.true_poses,
      totals.worn_refined);
  fmt::print("  {} points, refined in {:.0f} ms, with joining {:.0f} ms\n", map.size(), refine_ms, all_ms);
  fmt::print("  refined: {}\n", errors.summary());
  fmt::print("  points off the surface, RMS: perfect poses {:.2f} mm, refined {:.2f}, by joints {:.2f}\n",
             perfect_mm, refined_mm, joints_mm);
}

void study(const fs::path& folder, std::uint64_t seed, bool with_calibration, Totals& totals) {
  fmt::print("{}\n", seed);
  PanTiltChain chain;
  if (with_calibration) chain = study_calibration(folder / "calibrate", seed, totals).chain;
  study_map(folder / "map", seed, chain, totals);
  std::fflush(stdout);
}

void print_calibration(const Totals& totals) {
  fmt::print("all, refined with the calibrated geometry, put onto the truth: {}\n",
             totals.refined_by_calibration.summary());
  fmt::print("geometry within 1 mm and 0.1 deg: {} of {}\n", totals.calibrated, totals.lengths / 4);
  fmt::print("lengths within two of the deviations that calibration states: {} of {}\n",
             totals.within_two_sigma, totals.lengths);
}

}  // namespace

int main(int argc, char** argv) {
  const bool with_calibration = argc == 4;
  if (argc != 5 && !with_calibration) {
    fmt::print(stderr, "usage: rva_map_study FOLDER FIRST_SEED INSPECTIONS [map]\n");
    return 2;
  }
  const std::uint64_t first = std::stoull(argv[2]);
  const std::uint64_t count = std::stoull(argv[3]);
  Totals totals;
  for (std::uint64_t seed = first; seed < first + count; ++seed)
    study(fs::path(argv[1]) / std::to_string(seed), seed, with_calibration, totals);
  fmt::print("all, by joints: {}\n", totals.by_joints.summary());
  fmt::print("all, refined:   {}\n", totals.refined.summary());
  fmt::print("all, refined, put onto the truth: {}\n", totals.refined_among_each_other.summary());
  fmt::print("all, with play, put onto the truth, by joints: {}\n", totals.worn_by_joints.summary());
  fmt::print("all, with play, put onto the truth, refined:   {}\n", totals.worn_refined.summary());
  fmt::print("RMS against perfect poses: by joints {:.2f} (most {:.2f}), refined {:.3f} (most {:.3f})\n",
             quantile(totals.ratio_by_joints, 0.5), quantile(totals.ratio_by_joints, 1.0),
             quantile(totals.ratio_refined, 0.5), quantile(totals.ratio_refined, 1.0));
  if (with_calibration) print_calibration(totals);
  return 0;
}
