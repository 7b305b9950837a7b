// Measures whether recording keeps up with a camera: `rva_recording_bench CAPTURE MINUTES FOLDER`.
//
// The capture is replayed from memory in a loop at 30 frames per second, by a thread that drops frames that
// are not taken in time, as a device does. It is recorded into FOLDER, which must not exist yet.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "camera/live_camera.hpp"
#include "camera/recording.hpp"
#include "camera/replay_camera.hpp"
#include "capture/folder/capture_writer.hpp"
#include "capture/memory_capture.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"

namespace fs = std::filesystem;

namespace {

double resident_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) return std::strtod(line.c_str() + 6, nullptr) / 1024.0;
  }
  return 0.0;
}

void measure(const std::string& capture, double minutes, const fs::path& folder) {
  constexpr double rate_hz = 30.0;
  constexpr std::size_t most_bytes = 256UL << 20U;
  const auto frames = static_cast<std::size_t>(60.0 * minutes * rate_hz);
  if (!fs::create_directories(folder)) throw rva::Error(folder, "already exists", "give another folder");
  auto memory = rva::load_to_memory(*rva::open_capture(capture), most_bytes, {});
  rva::LiveCamera live(
      std::make_unique<rva::ReplayCamera>(std::move(memory), rva::ReplayOptions{.loop = true}), 1000.0);
  const std::unique_ptr<rva::Camera> camera = live.every_frame();
  rva::CaptureWriter writer(folder, camera->info());
  const rva::Stopwatch watch;
  const std::size_t tenth = std::max<std::size_t>(1, frames / 10);
  const rva::Recorded recorded =
      rva::record(*camera, frames, writer, [&](std::string_view, std::size_t done, std::size_t) {
        if (done % tenth == 0) fmt::print("{:6} frames, {:.1f} MB of memory\n", done, resident_mb());
        static_cast<void>(std::fflush(stdout));
      });
  const double seconds = 0.001 * watch.ms();
  fmt::print("{} frames in {:.1f} s: {:.2f} a second, {} lost\n", recorded.frames, seconds,
             static_cast<double>(recorded.frames) / seconds, recorded.lost);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: rva_recording_bench CAPTURE MINUTES FOLDER\n");
    return 2;
  }
  try {
    measure(argv[1], std::strtod(argv[2], nullptr), argv[3]);
    return 0;
  } catch (const rva::Error& error) {
    fmt::print(stderr, "rva_recording_bench: {}\n", error.what());
    return 1;
  }
}
