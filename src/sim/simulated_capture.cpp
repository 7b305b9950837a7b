#include "sim/simulated_capture.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "camera/recording.hpp"
#include "capture/folder/capture_writer.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/options.hpp"
#include "depth/image_file.hpp"
#include "sim/sensor/camera_models.hpp"
#include "sim/truth.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

// The settings of the simulation, so that the capture can be reproduced.
Json json_of(const SimulationOrigin& origin, const SimulatedCamera& camera) {
  Json options;
  StereoSensorOptions::describe(camera.options(), [&](const auto& value, const OptionField& field) {
    options[json_name(field)] = value;
  });
  Json simulation{{"scene", camera.scene().name},
                  {"seed", camera.seed()},
                  {"camera_model", origin.camera_model},
                  {"matcher", name_of_matcher(camera.options())},
                  {"options", options}};
  if (!origin.debris.empty()) simulation["debris"] = origin.debris;
  if (origin.debris_seed) simulation["debris_seed"] = *origin.debris_seed;
  return Json{{"simulation", simulation}};
}

void write_infrared(const SimulatedCamera& camera, const OutputFolder& out) {
  std::error_code ignored;  // write_file() reports the error
  std::filesystem::create_directory(out.path("infrared"), ignored);
  write_file(out.path("infrared/left.png"), encode_png(camera.left_infrared()));
  write_file(out.path("infrared/right.png"), encode_png(camera.right_infrared()));
}

}  // namespace

std::vector<std::string> simulated_capture_files() {
  std::vector<std::string> files = capture_files();
  files.insert(files.end(), {"truth/labels.png", "truth/depth.png", "truth/truth.json", "infrared/left.png",
                             "infrared/right.png"});
  return files;
}

void write_simulated_capture(SimulatedCamera& camera, const SimulationOrigin& origin,
                             const SimulatedCaptureOptions& options, const OutputFolder& out,
                             const Progress& progress) {
  CaptureWriter writer(out.path(""), camera.info(), json_text(json_of(origin, camera)));
  write_truth(camera, out);
  record(camera, options.frames, writer, progress);
  if (options.infrared) write_infrared(camera, out);
  if (options.lamp) record_lamp(camera, options.frames, writer, progress);
}

}  // namespace rva
