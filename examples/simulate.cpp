// Loads a scene, simulates a stereo depth camera in it, and writes ten frames as a capture folder. Run it as
// `build/examples/simulate data/scenes/three-tools.yaml /tmp/three-tools`; another SEED gives other noise.
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>

#include "camera/recording.hpp"
#include "capture/folder/capture_writer.hpp"
#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"

namespace {

void simulate(const std::filesystem::path& scene, const std::filesystem::path& out, std::uint64_t seed) {
  constexpr std::size_t frames = 10;
  const rva::StereoSensorOptions d435;  // the defaults are those of a D435
  rva::SimulatedCamera camera(rva::load_scene(scene), d435, seed, rva::ColorFrames::none);

  // The folder appears under its own name when it is complete, and not at all if something fails.
  rva::OutputFolder folder(out, rva::capture_files(), rva::Existing::refuse);
  rva::CaptureWriter writer(folder.path(""), camera.info());
  const rva::Recorded recorded = rva::record(camera, frames, writer, {});
  folder.commit();
  fmt::print("wrote {} frames of {} object(s) to {}\n", recorded.frames, camera.scene().objects.size(),
             out.string());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    fmt::print(stderr, "usage: simulate SCENE OUT [SEED]\n");
    return 2;
  }
  try {
    constexpr int decimal = 10;
    simulate(argv[1], argv[2], argc == 4 ? std::strtoull(argv[3], nullptr, decimal) : 1);
    return 0;
  } catch (const rva::Error& error) {
    fmt::print(stderr, "simulate: {}\n", error.what());
    return 1;
  }
}
