#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "camera/noise.hpp"
#include "camera/noise_files.hpp"
#include "cli/camera_check.hpp"
#include "cli/camera_uri.hpp"
#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"

namespace rva::cli {
namespace {

struct NoiseArguments {
  std::string capture;
  std::string camera;
  std::uint64_t seed = 1;
  CameraCheckArguments check;
  RealSenseOptions realsense;
  std::string out;
  CaptureFlags captures;
  NoiseOptions noise;
  bool overwrite = false;
  bool json = false;
};

void print_row(const char* name, const NoiseBin& bin) {
  print("{:>10}  {:>9}  {:>14.2f}  {:>11.2f}  {:>12}\n", name, bin.pixels, bin.median_std_mm, bin.p95_std_mm,
        bin.subpixel_rms_px ? fmt::format("{:.3f}", *bin.subpixel_rms_px) : "-");
}

// Distances with fewer pixels are in noise.json only: they are wrong matches more often than surfaces.
std::size_t fewest_pixels(const NoiseReport& report) {
  constexpr std::size_t at_least = 100;
  constexpr std::size_t of_all = 500;
  return std::max(at_least, report.overall.pixels / of_all);
}

void print_for_a_person(const NoiseArguments& arguments, const NoiseReport& report) {
  print("{} frames, {:.1f} % of pixels measured\n", report.frames, 100.0 * report.fill_rate);
  print("{:>10}  {:>9}  {:>14}  {:>11}  {:>12}\n", "distance m", "pixels", "median std mm", "95 % std mm",
        "sub-pixel px");
  const std::size_t fewest = fewest_pixels(report);
  std::size_t left_out = 0;
  for (const NoiseBin& bin : report.bins) {
    if (bin.pixels < fewest)
      left_out += bin.pixels > 0 ? 1 : 0;
    else
      print_row(fmt::format("{:.2f}-{:.2f}", bin.from_m, bin.to_m).c_str(), bin);
  }
  print_row("all", report.overall);
  if (left_out > 0)
    print("{} more distance(s) with fewer than {} pixels each are in noise.json\n", left_out, fewest);
  if (report.overall.pixels == 0) print("no pixel was measured twice, so the noise is unknown\n");
  print(
      "Welch's test, first against last {} frames: {:.1f} % of pixels differ (p < {}; {:.1f} % expected if "
      "nothing drifts)\n",
      report.welch_frames, 100.0 * report.welch_rejected, report.alpha, 100.0 * report.alpha);
  print("{}\n", arguments.out);
}

void measure(const NoiseArguments& arguments) {
  const CaptureOptions capture_options = arguments.captures.options();
  check_options(arguments.noise);
  OutputFolder out(arguments.out, noise_files(), arguments.overwrite ? Existing::replace : Existing::refuse);
  const auto capture = open_capture(arguments.capture, capture_options);
  const Noise noise = measure_noise(*capture, arguments.noise, terminal_progress());
  write_noise(noise, out);
  out.commit();
  if (arguments.json) {
    print("{}", json_file_text(json_of(noise.report)));
  } else {
    print_for_a_person(arguments, noise.report);
  }
}

void check(NoiseArguments arguments, Outcome& outcome) {
  if (!arguments.capture.empty() || !arguments.out.empty())
    throw UsageError("--camera", "checks a camera and writes no pictures", "leave out CAPTURE and --out");
  arguments.check.json = arguments.json;
  if (arguments.noise.frames != 0) arguments.check.frames = static_cast<std::size_t>(arguments.noise.frames);
  constexpr std::size_t least_frames = 4;
  if (arguments.check.frames < least_frames)
    throw UsageError("--frames", "too few to measure noise", "give 4 or more");
  const std::unique_ptr<Camera> camera =
      open_camera(arguments.camera, arguments.seed, arguments.captures.options(), arguments.realsense);
  if (!check_before_work(*camera, arguments.check)) outcome.status = status_detected;
}

}  // namespace

void add_noise_command(CLI::App& program, Outcome& outcome) {
  CLI::App& command = *program.add_subcommand("noise", "measures how much the depth of a still scene varies");
  const auto arguments = std::make_shared<NoiseArguments>();
  command.add_option("CAPTURE", arguments->capture, "capture of a scene in which nothing moved");
  command.add_option("--out", arguments->out, "folder for std.png, drift.png and noise.json")
      ->type_name("DIR");
  command
      .add_option(
          "--camera", arguments->camera,
          "instead of CAPTURE: check this camera on a scene that does not change, against its own history")
      ->type_name("URI");
  command.add_option("--history", arguments->check.history, "folder of the histories of cameras")
      ->type_name("DIR");
  command.add_option("--seed", arguments->seed, "seed of a simulated camera's noise")
      ->check(any_seed())
      ->capture_default_str();
  add_flags(command, arguments->noise);
  arguments->captures.add_without_unit_to(command);
  command.add_flag("--overwrite", arguments->overwrite, "replace an earlier result in DIR");
  command.add_flag("--json", arguments->json, "print noise.json instead of a table");
  add_flags(command, arguments->check.options);
  add_flags(command, arguments->realsense);
  command.callback([arguments, &outcome, &command] {
    if (command.count("--depth-unit") > 0)
      arguments->captures.depth_unit_mm = arguments->realsense.depth_unit_mm;
    if (!arguments->camera.empty()) {
      check(*arguments, outcome);
      return;
    }
    if (arguments->capture.empty())
      throw UsageError("CAPTURE", "is missing", "give a capture, or a camera with --camera");
    if (arguments->out.empty()) throw UsageError("--out", "is missing", "give a folder");
    measure(*arguments);
  });
}

}  // namespace rva::cli
