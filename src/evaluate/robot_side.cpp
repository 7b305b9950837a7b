#include "evaluate/robot_side.hpp"

#include <system_error>

#include "core/random.hpp"
#include "robot/dither.hpp"
#include "sim/simulated_robot.hpp"

namespace rva {

Captures RobotSide::open(int count) const {
  Captures opened;
  for (int i = 0; i < count; ++i) opened.push_back(open_capture(captures.at(static_cast<std::size_t>(i))));
  return opened;
}

RobotSide take_by_robot(const Scene& scene, const StereoSensorOptions& sensor,
                        const RobotSideOptions& options, std::uint64_t seed,
                        const std::filesystem::path& folder) {
  constexpr std::size_t settling = 1;  // as rva serve has it
  const Clock clock = unhurried_clock();
  SimulatedRobot robot({.rest_error_deg = options.rest_error_deg}, clock.now_s, mix(seed, 1));
  SimulatedCamera camera(scene, sensor, mix(seed, 2), options.color ? ColorFrames::all : ColorFrames::none,
                         [&robot] { return robot.true_joints(); });
  std::error_code ignored;  // take_views() reports the error
  std::filesystem::create_directories(folder, ignored);
  RobotSide side;
  const Progress note_joints = [&](std::string_view /*step*/, std::size_t done, std::size_t /*total*/) {
    if (done > 0) side.rested.push_back(robot.true_joints());
  };
  take_views({camera, robot, clock, PanTiltChain{}, scene.stand.base},
             dithered({scene.stand.pan_deg, scene.stand.tilt_deg}, options.captures, robot.limits()), folder,
             {static_cast<std::size_t>(options.frames), settling, options.lamp, options.baseline},
             note_joints);
  for (int i = 0; i < options.captures; ++i)
    side.captures.push_back(folder / view_name(static_cast<std::size_t>(i)));
  return side;
}

SimulatedCamera camera_at(const Scene& scene, const StereoSensorOptions& sensor, const PanTilt& joints) {
  return {scene, sensor, 0, ColorFrames::none, [joints] { return joints; }};
}

}  // namespace rva
