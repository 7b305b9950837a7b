#include "cli/live_rig.hpp"

#include <algorithm>
#include <utility>

#include "camera/replay_camera.hpp"
#include "capture/capture.hpp"
#include "capture/memory_capture.hpp"
#include "cli/camera_uri.hpp"
#include "cli/robot_uri.hpp"
#include "cli/simulated_view.hpp"
#include "cli/terminal_progress.hpp"
#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_bay.hpp"

namespace rva::cli {
namespace {

// The frames are decoded in advance, since decoding takes longer than showing them.
std::unique_ptr<Camera> open_replay(const std::string& path) {
  constexpr std::size_t most_bytes = 512UL << 20U;
  return std::make_unique<ReplayCamera>(load_to_memory(*open_capture(path), most_bytes, terminal_progress()),
                                        ReplayOptions{.loop = true});
}

bool has_changes(const Scene& scene) {
  return std::ranges::any_of(scene.objects, [](const SceneObject& object) {
    return object.role == Role::debris || object.role == Role::work;
  });
}

}  // namespace

LiveRig open_live_rig(const std::string& camera, const std::string& robot, std::uint64_t seed,
                      const RealSenseOptions& realsense) {
  constexpr std::string_view replay = "replay:";
  LiveRig rig;
  if (camera.starts_with(replay) && camera.size() > replay.size()) {
    if (robot != "none")
      throw UsageError("--robot", "cannot turn a recording", "leave it out, or give another --camera");
    rig.camera = open_replay(camera.substr(replay.size()));
    return rig;
  }
  if (is_device(camera)) {
    require_real_robot(robot);
    rig.camera = open_camera(camera, seed, {}, realsense);
    rig.robot = open_robot(robot, steady_clock(), seed).robot;
    return rig;
  }
  const SimulatedView view = parse_simulated_view(camera);
  Scene before = load_scene(scene_file(view.scene), {.no_debris = true});
  Scene after = load_scene(scene_file(view.scene));
  const bool work = has_changes(after);
  OpenRobot opened = open_robot(robot, steady_clock(), seed);
  if (robot == "sim") opened.robot->move_to({after.stand.pan_deg, after.stand.tilt_deg});
  rig.robot = std::move(opened.robot);
  auto bay = std::make_unique<SimulatedBay>(std::move(before), std::move(after), seed,
                                            joints_of(view, std::move(opened.joints)), opened.lamp);
  if (work) rig.simulated_work = [&bay = *bay](bool done) { bay.set_work_done(done); };
  rig.camera = std::move(bay);
  return rig;
}

}  // namespace rva::cli
