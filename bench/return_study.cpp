// Accuracy of the measurement of a robot's returns, against the true joints of the simulated robot.
//
// usage: rva_return_study SCENE lamp|color FIRST_SEED ROBOTS [RAYS]
//
// Prints a line for each robot, with the figures of all robots so far. RAYS: each way in a pixel, by
// default 2.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "map/repeatability.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"
#include "sim/simulated_robot.hpp"

namespace {

using namespace rva;

/// A camera whose lamp cannot be controlled, as that of a real one.
class WithoutLamp : public Camera {
 public:
  explicit WithoutLamp(Camera& camera) : camera_(camera) {}
  [[nodiscard]] CaptureInfo info() const override { return camera_.info(); }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override { return camera_.wait_for_frame(); }

 private:
  Camera& camera_;
};

struct ErrorSums {
  double sum_deg = 0.0;
  double squares_deg2 = 0.0;
  double most_deg = 0.0;
  int count = 0;

  void add(double error_deg) {
    sum_deg += error_deg;
    squares_deg2 += error_deg * error_deg;
    most_deg = std::max(most_deg, std::abs(error_deg));
    ++count;
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("mean {:+.4f} rms {:.4f} most {:.4f}", sum_deg / count,
                       std::sqrt(squares_deg2 / count), most_deg);
  }
};

struct Study {
  std::string scene;
  bool lamp = true;
  int rays = 2;
};

void measure(const Study& study, std::uint64_t seed, ErrorSums& pan, ErrorSums& tilt) {
  const Clock clock = unhurried_clock();
  SimulatedRobotOptions errors;
  errors.rest_error_deg = 0.16;
  SimulatedRobot robot(errors, clock.now_s, seed);
  StereoSensorOptions sensor;
  sensor.supersampling = study.rays;
  sensor.device = seed;
  SimulatedCamera camera(load_scene(study.scene), sensor, seed, ColorFrames::all,
                         [&] { return robot.true_joints(); });
  WithoutLamp without_lamp(camera);
  std::vector<PanTilt> truth;
  const PanTiltChain chain;
  const std::string base;
  const Rig rig{study.lamp ? static_cast<Camera&>(camera) : without_lamp, robot, clock, chain, base};
  const Repeatability measured =
      measure_repeatability(rig, {{-30.0, -35.0}, {0.0, -20.0}, {30.0, -5.0}}, {.returns = 12},
                            [&](auto, auto, auto) { truth.push_back(robot.true_joints()); });
  auto at = truth.begin();
  for (const PoseReturns& pose : measured.poses) {
    const PanTilt first = *at++;
    for (const MeasuredReturn& back : pose.returns) {
      pan.add(back.turn.pan_deg - (at->pan_deg - first.pan_deg));
      tilt.add(back.turn.tilt_deg - (at->tilt_deg - first.tilt_deg));
      ++at;
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr, "usage: rva_return_study SCENE lamp|color FIRST_SEED ROBOTS [RAYS]\n");
    return 2;
  }
  try {
    const Study study{argv[1], std::string(argv[2]) == "lamp", argc > 5 ? std::atoi(argv[5]) : 2};
    const std::uint64_t first = std::strtoull(argv[3], nullptr, 10);
    const std::uint64_t robots = std::strtoull(argv[4], nullptr, 10);
    ErrorSums pan;
    ErrorSums tilt;
    for (std::uint64_t seed = first; seed < first + robots; ++seed) {
      measure(study, seed, pan, tilt);
      fmt::print("{:3} returns, error in degrees: pan {}; tilt {}\n", pan.count, pan.text(), tilt.text());
      static_cast<void>(std::fflush(stdout));
    }
  } catch (const Error& error) {
    fmt::print(stderr, "rva_return_study: {}\n", error.what());
    return 1;
  }
  return 0;
}
