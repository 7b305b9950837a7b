#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "capture/mcap/mcap_export.hpp"
#include "capture/open3d/open3d_writer.hpp"
#include "cli/commands.hpp"
#include "cli/option_flags.hpp"
#include "cli/output_file.hpp"
#include "cli/printing.hpp"
#include "cli/terminal_progress.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "map/capture_points.hpp"
#include "map/point_files.hpp"

namespace fs = std::filesystem;

namespace rva::cli {
namespace {

struct ExportArguments {
  std::string capture;
  std::string to;
  std::string out;
  CaptureFlags captures;
  bool overwrite = false;
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
    OutputFolder out(arguments.out, open3d_files(),
                     arguments.overwrite ? Existing::replace : Existing::refuse);
    write_open3d_folder(*capture, out.path(""), terminal_progress());
    out.commit();
  } else {
    require_replaceable(arguments.out, arguments.overwrite);
    arguments.to == "mcap" ? export_recording(arguments, *capture) : export_points(arguments, *capture);
  }
  print("{}\n", arguments.out);
}

}  // namespace

void add_export_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("export", "writes a capture as other programs read it");
  const auto arguments = std::make_shared<ExportArguments>();
  command.add_option("CAPTURE", arguments->capture, "a capture")->required();
  command
      .add_option("--to", arguments->to,
                  "ply or pcd: one cloud of points; open3d: a folder of frames; mcap: a recording for ROS 2 "
                  "and Foxglove")
      ->required()
      ->check(CLI::IsMember({"ply", "pcd", "open3d", "mcap"}))
      ->type_name("FORMAT");
  command.add_option("--out", arguments->out, "file, or folder for open3d")->required()->type_name("PATH");
  arguments->captures.add_to(command);
  command.add_flag("--overwrite", arguments->overwrite, "replace what is there");
  command.callback([arguments] { export_capture(*arguments); });
}

}  // namespace rva::cli
