#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "camera/recording.hpp"
#include "capture/folder/capture_writer.hpp"
#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "depth/image_file.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/sensor/camera_models.hpp"
#include "sim/simulated_camera.hpp"
#include "sim/truth.hpp"

namespace rva::cli {
namespace {

using Json = nlohmann::ordered_json;

struct SimulateArguments {
  std::string scene;
  std::string out;
  std::size_t frames = 40;
  std::uint64_t seed = 1;
  std::string debris;
  std::uint64_t debris_seed = 0;
  std::vector<double> position_m;
  double pan_deg = 0.0;
  double tilt_deg = 0.0;
  bool all_colors = false;
  bool infrared = false;
  bool lamp = false;
  std::string camera_model = "d435";
  StereoSensorOptions sensor;
  bool overwrite = false;
};

SceneOverrides overrides_from(const CLI::App& command, const SimulateArguments& arguments) {
  SceneOverrides overrides;
  overrides.no_debris = arguments.debris == "none";
  if (command.count("--debris") > 0 && !overrides.no_debris) overrides.debris_file = arguments.debris;
  if (command.count("--debris-seed") > 0) overrides.debris_seed = arguments.debris_seed;
  if (!arguments.position_m.empty())
    overrides.position_m =
        Eigen::Vector3d(arguments.position_m[0], arguments.position_m[1], arguments.position_m[2]);
  if (command.count("--pan") > 0) overrides.pan_deg = arguments.pan_deg;
  if (command.count("--tilt") > 0) overrides.tilt_deg = arguments.tilt_deg;
  return overrides;
}

// The settings of the simulation, so that the capture can be reproduced.
Json json_of(const SimulateArguments& arguments, const SceneOverrides& overrides, const Scene& scene) {
  Json options;
  StereoSensorOptions::describe(arguments.sensor, [&](const auto& value, const OptionField& field) {
    options[json_name(field)] = value;
  });
  Json simulation{{"scene", scene.name},
                  {"seed", arguments.seed},
                  {"camera_model", arguments.camera_model},
                  {"matcher", name_of_matcher(arguments.sensor)},
                  {"options", options}};
  if (!arguments.debris.empty()) simulation["debris"] = arguments.debris;
  if (overrides.debris_seed) simulation["debris_seed"] = *overrides.debris_seed;
  return Json{{"simulation", simulation}};
}

std::vector<std::string> files_of_a_simulated_capture() {
  std::vector<std::string> files = capture_files();
  files.insert(files.end(), {"truth/labels.png", "truth/depth.png", "truth/truth.json", "infrared/left.png",
                             "infrared/right.png"});
  return files;
}

void write_infrared(const SimulatedCamera& camera, const OutputFolder& out) {
  std::error_code ignored;  // write_file() reports the error
  std::filesystem::create_directory(out.path("infrared"), ignored);
  write_file(out.path("infrared/left.png"), encode_png(camera.left_infrared()));
  write_file(out.path("infrared/right.png"), encode_png(camera.right_infrared()));
}

// The options of the camera model, except those that were given explicitly.
StereoSensorOptions sensor_of(const CLI::App& command, const std::string& model) {
  StereoSensorOptions sensor = camera_model(model);
  StereoSensorOptions::describe(sensor, [&](auto& value, const OptionField& field) {
    const CLI::Option* const option = command.get_option("--" + std::string(field.name));
    if (option->count() > 0) value = option->as<std::decay_t<decltype(value)>>();
  });
  return sensor;
}

void simulate(const CLI::App& command, SimulateArguments arguments) {
  check_options(arguments.sensor);
  arguments.sensor = sensor_of(command, arguments.camera_model);
  OutputFolder out(arguments.out, files_of_a_simulated_capture(),
                   arguments.overwrite ? Existing::replace : Existing::refuse);
  const SceneOverrides overrides = overrides_from(command, arguments);
  SimulatedCamera camera(load_scene(arguments.scene, overrides), arguments.sensor, arguments.seed,
                         arguments.all_colors ? ColorFrames::all : ColorFrames::first);
  if (arguments.lamp && !camera.has_lamp())
    throw UsageError("--lamp", "there is none with --lamp-light 0", "leave one of them out");
  CaptureWriter writer(out.path(""), camera.info(), json_text(json_of(arguments, overrides, camera.scene())));
  write_truth(camera, out);
  record(camera, arguments.frames, writer, terminal_progress());
  if (arguments.infrared) write_infrared(camera, out);
  if (arguments.lamp) record_lamp(camera, arguments.frames, writer, terminal_progress());
  out.commit();
  print("{}\n", arguments.out);
}

}  // namespace

void add_simulate_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("simulate", "renders a capture of a scene, with its truth");
  const auto arguments = std::make_shared<SimulateArguments>();
  command.add_option("SCENE", arguments->scene, "scene file (docs/scenes.md)")->required();
  command.add_option("--out", arguments->out, "capture folder to write")->required()->type_name("DIR");
  command.add_option("--frames", arguments->frames, "depth frames")
      ->check(frame_count())
      ->capture_default_str();
  command.add_option("--seed", arguments->seed, "of all noise; the same seed gives the same bytes")
      ->check(any_seed())
      ->capture_default_str();
  command
      .add_option("--debris", arguments->debris,
                  "none: the bay as it was before the work; or a scene file whose debris is used instead")
      ->type_name("none|FILE");
  command
      .add_option("--debris-seed", arguments->debris_seed, "seed of debris that the scene places at random")
      ->check(any_seed());
  command.add_option("--position", arguments->position_m, "where the robot's foot stands")
      ->check(number_within(-100.0, 100.0))
      ->type_name("X,Y,Z")
      ->delimiter(',')
      ->expected(3);
  command.add_option("--pan", arguments->pan_deg, "first joint, positive to the left")
      ->check(number_within(-180.0, 180.0))
      ->type_name("deg");
  command.add_option("--tilt", arguments->tilt_deg, "second joint, positive up")
      ->check(number_within(-90.0, 90.0))
      ->type_name("deg");
  command
      .add_option(
          "--camera-model", arguments->camera_model,
          "with another matcher: d435, census-5, census-13, semi-global, correlation-5, correlation-9, or "
          "random:SEED or imperfect:SEED, drawn at random")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_flag("--all-colors", arguments->all_colors,
                   "a colour image with every frame, not the first only");
  command.add_flag("--infrared", arguments->infrared,
                   "also write what both infrared imagers saw in the last frame, 10 bits");
  command.add_flag("--lamp", arguments->lamp,
                   "also infrared images of as many frames with the projector off and the lamp on");
  add_flags(command, arguments->sensor);
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier capture in DIR");
  command.callback([arguments, &command] { simulate(command, *arguments); });
}

}  // namespace rva::cli
