#include <memory>
#include <string>

#include "camera/recording.hpp"
#include "cli/camera_uri.hpp"
#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "depth/capture_writer.hpp"

namespace rva::cli {
namespace {

struct RecordArguments {
  std::string camera;
  std::string out;
  std::size_t frames = 40;
  std::uint64_t seed = 1;
  CaptureFlags recording;
  bool overwrite = false;
};

void record_capture(const CLI::App& command, const RecordArguments& arguments) {
  if (command.count("--seed") > 0 && !arguments.camera.starts_with("sim:"))
    throw UsageError("--seed", "has no say in " + printable(arguments.camera),
                     "leave it out; it is for sim:SCENE");
  const CaptureOptions recording = arguments.recording.options();
  OutputFolder out(arguments.out, capture_files(),
                   arguments.overwrite ? Existing::replace : Existing::refuse);
  const std::unique_ptr<Camera> camera = open_camera(arguments.camera, arguments.seed, recording);
  const CaptureInfo info = camera->info();
  // What a replayed capture says beyond the format stays with it.
  const CaptureWriter writer(
      out.path(""), info,
      info.format == "rva-capture" && !info.source_json.empty() ? info.source_json : "{}");
  record(*camera, arguments.frames, writer, terminal_progress());
  out.commit();
  print("{}\n", arguments.out);
}

}  // namespace

void add_record_command(CLI::App& program, Outcome& /*outcome*/) {
  CLI::App& command = *program.add_subcommand("record", "records a capture from a camera");
  const auto arguments = std::make_shared<RecordArguments>();
  command.add_option("--camera", arguments->camera, "sim:SCENE or replay:PATH")->required()->type_name("URI");
  command.add_option("--out", arguments->out, "capture folder to write")->required()->type_name("DIR");
  command.add_option("--frames", arguments->frames, "depth frames")
      ->check(frame_count())
      ->capture_default_str();
  command.add_option("--seed", arguments->seed, "of a simulated camera's noise")
      ->check(any_seed())
      ->capture_default_str();
  arguments->recording.add_to(command);
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier capture in DIR");
  command.callback([arguments, &command] { record_capture(command, *arguments); });
}

}  // namespace rva::cli
