#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "camera/recording.hpp"
#include "capture/folder/capture_writer.hpp"
#include "cli/camera_uri.hpp"
#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "robot/dither.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/simulated_camera.hpp"
#include "sim/simulated_robot.hpp"

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

// Frames of a device cannot be recorded a second time, so those that were recorded before a failure are kept.
Recorded record_once(Camera& camera, std::size_t frames, CaptureWriter& writer, OutputFolder& out) {
  std::size_t done = 0;
  const Progress shown = terminal_progress();
  const Progress counted = [&](std::string_view step, std::size_t now, std::size_t total) {
    done = now;
    if (shown) shown(step, now, total);
  };
  try {
    return record(camera, frames, writer, counted);
  } catch (const Interrupted&) {
    if (done > 0)
      fmt::print(stderr, "rva: {} frame(s) are kept in {}\n", done, printable(out.keep_partial()));
    throw;
  } catch (const Error& error) {
    if (done == 0) throw;
    throw Error(error.source(),
                fmt::format("{} ({} frame(s) until then are kept in {})", error.problem(), done,
                            printable(out.keep_partial())),
                error.remedy());
  }
}

void require_lamp(const Camera& camera, const RecordArguments& arguments) {
  if (arguments.lamp && !camera.has_lamp())
    throw UsageError("--lamp", printable(arguments.camera) + " has no lamp", "leave it out");
}

void record_capture(const CLI::App& command, const RecordArguments& arguments) {
  if (command.count("--seed") > 0 && !arguments.camera.starts_with("sim:"))
    throw UsageError("--seed", "has no effect with " + printable(arguments.camera),
                     "leave it out; it is for sim:SCENE");
  const CaptureOptions recording = arguments.recording.options();
  OutputFolder out(arguments.out, capture_files(), arguments.overwrite ? Existing::replace : Existing::refuse,
                   is_device(arguments.camera) ? Remains::keep : Remains::remove);
  for (const std::filesystem::path& remains : out.remains())
    fmt::print(stderr,
               "rva: {} contains an unfinished recording of a program that was killed; keep or remove it\n",
               printable(remains));
  const std::unique_ptr<Camera> camera =
      open_camera(arguments.camera, arguments.seed, recording, arguments.realsense);
  const CaptureInfo info = camera->info();
  require_lamp(*camera, arguments);
  // Fields of a replayed capture that are not part of the format are kept.
  CaptureWriter writer(out.path(""), info,
                       info.format == "rva-capture" && !info.source_json.empty() ? info.source_json : "{}");
  const Recorded recorded = is_device(arguments.camera)
                                ? record_once(*camera, arguments.frames, writer, out)
                                : record(*camera, arguments.frames, writer, terminal_progress());
  if (arguments.lamp) record_lamp(*camera, arguments.frames, writer, terminal_progress());
  out.commit();
  print("{}\n", arguments.out);
  if (recorded.lost > 0) print("{} frame(s) were lost between those recorded\n", recorded.lost);
}

std::string dither_name(int number) { return fmt::format("dither-{:02}", number); }

// The files of several captures in one folder, each in a folder of its own.
std::vector<std::string> dithered_capture_files() {
  std::vector<std::string> files;
  for (int k = 0; k < most_dithers; ++k) {
    for (const std::string& file : capture_files()) files.push_back(dither_name(k) + "/" + file);
  }
  return files;
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
  int number = 0;
  for (const PanTilt& offset : dither_offsets(arguments.dither)) {
    approach(robot, {scene.stand.pan_deg + offset.pan_deg, scene.stand.tilt_deg + offset.tilt_deg}, clock);
    const std::filesystem::path folder = out.path(dither_name(number++));
    std::error_code ignored;  // the writer reports the error
    std::filesystem::create_directory(folder, ignored);
    CaptureWriter writer(folder, camera.info());
    record(camera, arguments.frames, writer, terminal_progress());
    if (arguments.lamp) record_lamp(camera, arguments.frames, writer, terminal_progress());
  }
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
  command.add_option("--out", arguments->out, "capture folder to write")->required()->type_name("DIR");
  command.add_option("--frames", arguments->frames, "depth frames")
      ->check(frame_count())
      ->capture_default_str();
  command.add_option("--seed", arguments->seed, "seed of a simulated camera's noise")
      ->check(any_seed())
      ->capture_default_str();
  command
      .add_option("--dither", arguments->dither,
                  "captures, a few servo steps apart, in folders dither-00, dither-01, ... of DIR")
      ->check(number_within(1, most_dithers))
      ->capture_default_str();
  command.add_flag("--lamp", arguments->lamp,
                   "also infrared images of as many frames with the projector off and the lamp on");
  arguments->recording.add_without_unit_to(command);
  add_flags(command, arguments->realsense);
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier capture in DIR");
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
