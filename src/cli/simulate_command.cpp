#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/sensor/camera_models.hpp"
#include "sim/simulated_camera.hpp"
#include "sim/simulated_capture.hpp"

namespace rva::cli {
namespace {

struct SimulateArguments {
  std::string scene;
  std::string out;
  std::size_t frames = SimulatedCaptureOptions{}.frames;
  std::uint64_t seed = default_seed;
  std::string debris;
  std::uint64_t debris_seed = 0;
  std::vector<double> position_m;
  double pan_deg = 0.0;
  double tilt_deg = 0.0;
  bool all_colors = false;
  bool infrared = false;
  bool lamp = false;
  std::string camera_model = SimulationOrigin{}.camera_model;
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
  OutputFolder out(arguments.out, simulated_capture_files(),
                   arguments.overwrite ? Existing::replace : Existing::refuse);
  const SceneOverrides overrides = overrides_from(command, arguments);
  SimulatedCamera camera(load_scene(arguments.scene, overrides), arguments.sensor, arguments.seed,
                         arguments.all_colors ? ColorFrames::all : ColorFrames::first);
  if (arguments.lamp && !camera.has_lamp())
    throw UsageError("--lamp", "there is none with --lamp-light 0", "leave one of them out");
  write_simulated_capture(
      camera,
      {.camera_model = arguments.camera_model,
       .debris = arguments.debris,
       .debris_seed = overrides.debris_seed},
      {.frames = arguments.frames, .infrared = arguments.infrared, .lamp = arguments.lamp}, out,
      terminal_progress());
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
