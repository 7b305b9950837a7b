#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "camera/capture_recording.hpp"
#include "capture/folder/capture_writer.hpp"
#include "cli/camera_uri.hpp"
#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "core/replaceable_file.hpp"
#include "map/dithered_recording.hpp"
#include "robot/dither.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"
#include "sim/simulated_robot.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct RecordArguments {
  std::string camera;
  std::string out;
  std::size_t frames = 40;
  std::uint64_t seed = 1;
  int dither = 1;
  CaptureFlags recording;
  RealSenseOptions realsense;
  bool lamp = false;
  bool overwrite = false;
};

void require_lamp(const Camera& camera, const RecordArguments& arguments) {
  if (arguments.lamp && !camera.has_lamp())
    throw UsageError("--lamp", printable(arguments.camera) + " has no lamp", "leave it out");
}

std::unique_ptr<Camera> camera_of(const RecordArguments& arguments) {
  std::unique_ptr<Camera> camera =
      open_camera(arguments.camera, arguments.seed, arguments.recording.options(), arguments.realsense);
  require_lamp(*camera, arguments);
  return camera;
}

CaptureRecording recording_of(const RecordArguments& arguments) {
  return {.frames = arguments.frames, .lamp = arguments.lamp, .keep = is_device(arguments.camera)};
}

Recorded record_into_folder(const RecordArguments& arguments) {
  OutputFolder out(arguments.out, capture_files(), arguments.overwrite ? Existing::replace : Existing::refuse,
                   is_device(arguments.camera) ? Remains::keep : Remains::remove);
  for (const fs::path& remains : out.remains())
    fmt::print(stderr,
               "rva: {} contains an unfinished recording of a program that was killed; keep or remove it\n",
               printable(remains));
  return rva::record_capture(*camera_of(arguments), recording_of(arguments), out, terminal_progress());
}

Recorded record_into_mcap(const RecordArguments& arguments) {
  require_replaceable(arguments.out, arguments.overwrite);
  return rva::record_capture(*camera_of(arguments), recording_of(arguments), fs::path(arguments.out),
                             terminal_progress());
}

Recorded record_into(const RecordArguments& arguments) {
  try {
    return fs::path(arguments.out).extension() == ".mcap" ? record_into_mcap(arguments)
                                                          : record_into_folder(arguments);
  } catch (const RecordingInterrupted& interrupted) {
    fmt::print(stderr, "rva: {} frame(s) are kept in {}\n", interrupted.frames(),
               printable(interrupted.kept()));
    throw;
  }
}

void record_capture(const CLI::App& command, const RecordArguments& arguments) {
  if (command.count("--seed") > 0 && !arguments.camera.starts_with("sim:"))
    throw UsageError("--seed", "has no effect with " + printable(arguments.camera),
                     "leave it out; it is for sim:SCENE");
  const Recorded recorded = record_into(arguments);
  print("{}\n", arguments.out);
  if (recorded.lost > 0) print("{} frame(s) were lost between those recorded\n", recorded.lost);
}

void record_dithered(const RecordArguments& arguments) {
  constexpr std::string_view simulated = "sim:";
  if (!arguments.camera.starts_with(simulated))
    throw UsageError("--dither", "needs a robot that turns the camera", "give --camera sim:SCENE");
  OutputFolder out(arguments.out, dithered_capture_files(),
                   arguments.overwrite ? Existing::replace : Existing::refuse);
  const Scene scene = load_scene(arguments.camera.substr(simulated.size()));
  const Clock clock = unhurried_clock();
  SimulatedRobot robot({}, clock.now_s);
  SimulatedCamera camera(scene, StereoSensorOptions{}, arguments.seed, ColorFrames::all,
                         [&robot] { return robot.true_joints(); });
  record_dithered(camera, robot, clock,
                  {.around = {scene.stand.pan_deg, scene.stand.tilt_deg},
                   .captures = arguments.dither,
                   .frames = arguments.frames,
                   .lamp = arguments.lamp},
                  out.path(""), terminal_progress());
  out.commit();
  print("{}\n", arguments.out);
}

}  // namespace

void add_record_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("record", "records a capture from a camera");
  const auto arguments = std::make_shared<RecordArguments>();
  command.add_option("--camera", arguments->camera, "sim:SCENE, replay:PATH or realsense[:SERIAL]")
      ->required()
      ->type_name("URI");
  command.add_option("--out", arguments->out, "capture folder to write, or a recording if it ends in .mcap")
      ->required()
      ->type_name("PATH");
  command.add_option("--frames", arguments->frames, "depth frames")
      ->check(frame_count())
      ->capture_default_str();
  command.add_option("--seed", arguments->seed, "seed of a simulated camera's noise")
      ->check(any_seed())
      ->capture_default_str();
  command
      .add_option("--dither", arguments->dither,
                  "captures, a few servo steps apart, in folders dither-00, dither-01, ... of PATH")
      ->check(number_within(1, most_dithers))
      ->capture_default_str();
  command.add_flag("--lamp", arguments->lamp,
                   "also infrared images of as many frames with the projector off and the lamp on");
  arguments->recording.add_without_unit_to(command);
  add_flags(command, arguments->realsense);
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier capture");
  command.callback([arguments, &command] {
    if (command.count("--depth-unit") > 0)
      arguments->recording.depth_unit_mm = arguments->realsense.depth_unit_mm;
    if (command.count("--dither") > 0)
      record_dithered(*arguments);
    else
      record_capture(command, *arguments);
  });
}

}  // namespace rva::cli
