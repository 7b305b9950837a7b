#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "capture/mcap/mcap_export.hpp"
#include "capture/open3d/open3d_writer.hpp"
#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/printing.hpp"
#include "cli/recorded_inspection.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "core/replaceable_file.hpp"
#include "map/capture_points.hpp"
#include "map/point_files.hpp"
#include "server/inspection_export.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct ExportArguments {
  std::string capture;
  std::string data;
  std::int64_t inspection = 0;
  std::string to;
  std::string out;
  CaptureFlags captures;
  bool overwrite = false;

  [[nodiscard]] Existing existing() const { return overwrite ? Existing::replace : Existing::refuse; }
};

void export_points(const ExportArguments& arguments, const Capture& capture) {
  const std::vector<MapPoint> points = points_of(capture, terminal_progress());
  replace_file(arguments.out, arguments.to == "ply" ? encode_ply(points, PointFrame::depth_camera)
                                                    : encode_pcd(points, PointFrame::depth_camera));
}

void export_recording(const ExportArguments& arguments, const Capture& capture) {
  std::vector<std::string> notes;
  replace_file(arguments.out,
               [&](const fs::path& partial) { notes = write_mcap(capture, partial, terminal_progress()); });
  for (const std::string& note : notes) fmt::print(stderr, "rva: warning: {}\n", note);
}

void export_capture(const ExportArguments& arguments) {
  const std::unique_ptr<Capture> capture = open_capture(arguments.capture, arguments.captures.options());
  if (arguments.to == "open3d") {
    OutputFolder out(arguments.out, open3d_files(), arguments.existing());
    write_open3d_folder(*capture, out.path(""), terminal_progress());
    out.commit();
  } else {
    require_replaceable(arguments.out, arguments.overwrite);
    arguments.to == "mcap" ? export_recording(arguments, *capture) : export_points(arguments, *capture);
  }
}

void export_recorded_inspection(const ExportArguments& arguments) {
  const InspectionHistory history = recorded_inspection(arguments.data, arguments.inspection);
  export_inspection(history, arguments.data, arguments.out, arguments.existing(), terminal_progress());
}

// Either a capture in a format of another program, or an inspection of a data folder.
void check_source(const ExportArguments& arguments) {
  const bool capture = !arguments.capture.empty();
  const bool inspection = arguments.inspection != 0 || !arguments.data.empty();
  const bool complete =
      capture ? !arguments.to.empty() : arguments.inspection != 0 && !arguments.data.empty();
  if (capture == inspection || !complete)
    throw UsageError("export", "it is not clear what to export",
                     "give a capture and its format, as in CAPTURE --to ply, or an inspection and its "
                     "folder, as in --data DIR --inspection 12");
  if (inspection && !arguments.to.empty())
    throw UsageError("--to", "is the format of a capture", "leave it out for an inspection");
}

void run(const ExportArguments& arguments) {
  check_source(arguments);
  arguments.capture.empty() ? export_recorded_inspection(arguments) : export_capture(arguments);
  print("{}\n", arguments.out);
}

}  // namespace

void add_export_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "export", "writes a capture as other programs read it, or an inspection with all its files");
  const auto arguments = std::make_shared<ExportArguments>();
  command.add_option("CAPTURE", arguments->capture, "a capture");
  command
      .add_option("--to", arguments->to,
                  "ply or pcd: one cloud of points; open3d: a folder of frames; mcap: a recording for ROS 2 "
                  "and Foxglove")
      ->check(CLI::IsMember({"ply", "pcd", "open3d", "mcap"}))
      ->type_name("FORMAT");
  command.add_option("--data", arguments->data, "folder of inspections, as for rva serve")->type_name("DIR");
  command
      .add_option("--inspection", arguments->inspection,
                  "number of an inspection in --data: a folder of all its captures, results, pictures and "
                  "decisions")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  command.add_option("--out", arguments->out, "file, or folder for open3d and inspections")
      ->required()
      ->type_name("PATH");
  arguments->captures.add_to(command);
  command.add_flag("--overwrite", arguments->overwrite, "replace what is there");
  command.callback([arguments] { run(*arguments); });
}

}  // namespace rva::cli
