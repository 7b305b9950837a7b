#include "map/dithered_recording.hpp"

#include <fmt/format.h>

#include <system_error>

#include "camera/recording.hpp"
#include "capture/folder/capture_writer.hpp"
#include "robot/dither.hpp"

namespace rva {
namespace {

std::string dither_name(int number) { return fmt::format("dither-{:02}", number); }

}  // namespace

void record_dithered(Camera& camera, Robot& robot, const Clock& clock, const DitheredRecording& recording,
                     const std::filesystem::path& folder, const Progress& progress) {
  int number = 0;
  for (const PanTilt& offset : dither_offsets(recording.captures)) {
    approach(robot, {recording.around.pan_deg + offset.pan_deg, recording.around.tilt_deg + offset.tilt_deg},
             clock);
    const std::filesystem::path own = folder / dither_name(number++);
    std::error_code ignored;  // the writer reports the error
    std::filesystem::create_directory(own, ignored);
    CaptureWriter writer(own, camera.info());
    record(camera, recording.frames, writer, progress);
    if (recording.lamp) record_lamp(camera, recording.frames, writer, progress);
  }
}

std::vector<std::string> dithered_capture_files() {
  std::vector<std::string> files;
  for (int k = 0; k < most_dithers; ++k) {
    for (const std::string& file : capture_files()) files.push_back(dither_name(k) + "/" + file);
  }
  return files;
}

}  // namespace rva
