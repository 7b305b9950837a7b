#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <string>
#include <vector>

#include "capture/mcap/mcap_export.hpp"
#include "capture/open3d/open3d_writer.hpp"
#include "captures.hpp"
#include "core/file.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "core/replaceable_file.hpp"
#include "keywords.hpp"
#include "long_call.hpp"
#include "map/capture_points.hpp"
#include "map/point_files.hpp"
#include "module.hpp"

namespace rva::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

struct ExportArguments {
  bool overwrite = false;
  CaptureArguments captures{};
  py::object progress = py::none();

  static void describe_keywords(auto&& self, auto&& visit) {
    visit("overwrite", self.overwrite, "replace what is there");
    CaptureArguments::describe_keywords(self.captures, visit);
    visit("progress", self.progress, progress_sentence);
  }
};

void write_folder(const Capture& capture, const fs::path& folder, bool overwrite, const Progress& progress) {
  OutputFolder out(folder, open3d_files(), overwrite ? Existing::replace : Existing::refuse);
  write_open3d_folder(capture, out.path(""), progress);
  out.commit();
}

std::vector<std::string> write(const Capture& capture, const std::string& format, const fs::path& out,
                               const ExportArguments& arguments) {
  const Progress progress = progress_to(arguments.progress);
  if (format == "open3d") {
    write_folder(capture, out, arguments.overwrite, progress);
    return {};
  }
  require_replaceable(out, arguments.overwrite);
  std::vector<std::string> notes;
  if (format == "mcap") {
    replace_file(out, [&](const fs::path& partial) { notes = write_mcap(capture, partial, progress); });
    return notes;
  }
  const std::vector<MapPoint> points = points_of(capture, progress);
  replace_file(out, format == "ply" ? encode_ply(points, PointFrame::depth_camera)
                                    : encode_pcd(points, PointFrame::depth_camera));
  return notes;
}

std::vector<std::string> export_capture(py::handle capture, const std::string& to, const fs::path& out,
                                        const py::kwargs& given) {
  ExportArguments arguments;
  take("export", given, arguments);
  if (to != "ply" && to != "pcd" && to != "open3d" && to != "mcap")
    throw UsageError("to", printable(to) + " is not a format", "give ply, pcd, open3d or mcap");
  const auto opened = capture_from(capture, arguments.captures);
  return without_lock([&] { return write(*opened->capture, to, out, arguments); });
}

}  // namespace

void add_export(py::module_& module) {
  const auto text = description<ExportArguments>(
      "export", "capture, to, out",
      "Writes a capture as other programs read it, as rva export does: to is 'ply' or 'pcd' (one cloud of "
      "points), 'open3d' (a folder of frames) or 'mcap' (a recording for ROS 2 and Foxglove). Returns "
      "warnings on what could not be written. Takes a path or a Capture.");
  module.def("export", export_capture, py::arg("capture"), py::arg("to"), py::arg("out"), text.c_str());
}

}  // namespace rva::python
