#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "capture/capture.hpp"
#include "core/file.hpp"
#include "tests/fuzz/load_or_refuse.hpp"

namespace {

// Recordings are read from files: one of this process, in memory.
const std::string& file() {
  static const std::string name = "/dev/shm/rva-fuzz-" + std::to_string(::getpid()) + ".recording";
  static const int removed_at_exit = std::atexit([] { std::filesystem::remove(name); });
  static_cast<void>(removed_at_exit);
  return name;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rva::write_file(file(), std::as_bytes(std::span(data, size)));
  const auto capture = rva::load_or_refuse([] { return rva::open_capture(file()); });
  if (!capture) return 0;
  const rva::Capture& recording = **capture;
  rva::require(recording.depth_frames() > 0, "a capture has a frame");
  for (std::size_t i = 0; i < std::min<std::size_t>(4, recording.depth_frames()); ++i) {
    const auto depth = rva::load_or_refuse([&] { return recording.depth(i); });
    rva::require(!depth || (depth->width() == recording.info().depth.width &&
                            depth->height() == recording.info().depth.height),
                 "a depth image is of the size that is stated");
    static_cast<void>(rva::load_or_refuse([&] { return recording.color_of(i); }));
    for (const rva::Imager imager : rva::both_imagers)
      static_cast<void>(rva::load_or_refuse([&] { return recording.infrared_of(i, imager); }));
    static_cast<void>(rva::load_or_refuse([&] { return recording.metadata_of(i); }));
  }
  return 0;
}
