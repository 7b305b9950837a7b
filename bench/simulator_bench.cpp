// Speed of the simulated camera: rendering of a pose, frames at rest and frames in motion.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"

namespace {

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double least_s(int times, const std::function<void()>& work) {
  double least = seconds(work);
  for (int i = 1; i < times; ++i) least = std::min(least, seconds(work));
  return least;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: {} SCENE\n", argv[0]);
    return 2;
  }
  using namespace rva;
  const Scene scene = load_scene(argv[1]);
  const StereoSensorOptions options;
  const RayCaster rays(scene);
  const InfraredRenderer renderer(scene, rays, options);
  PanTilt joints{scene.stand.pan_deg, scene.stand.tilt_deg};
  SimulatedCamera camera(scene, options, 1, ColorFrames::all, [&joints] { return joints; });
  const Transform pose = camera.world_from_camera();
  fmt::print("pose, both infrared imagers, shadows, 2 x 2 rays a pixel: {:.2f} s\n",
             least_s(3, [&] { (void)renderer.render(pose, Misalignment{}, 2); }));

  constexpr int frames = 20;
  const auto take = [&](double step_deg) {
    return frames / seconds([&] {
             for (int i = 0; i < frames; ++i) {
               joints.pan_deg += step_deg;
               (void)camera.wait_for_frame();
             }
           });
  };
  (void)camera.wait_for_frame();
  fmt::print("live, depth and colour, the view stands still: {:.1f} frames a second\n",
             std::max(take(0.0), take(0.0)));
  fmt::print("live, depth and colour, the view moves: {:.1f} frames a second\n",
             std::max(take(0.3), take(-0.3)));
}
