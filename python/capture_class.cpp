#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "capture/capture_summary.hpp"
#include "captures.hpp"
#include "core/path_text.hpp"
#include "images.hpp"
#include "long_call.hpp"
#include "module.hpp"
#include "python_json.hpp"

namespace rva::python {
namespace {

namespace py = pybind11;

struct OpenArguments {
  CaptureArguments captures;

  static void describe_keywords(auto&& self, auto&& visit) {
    CaptureArguments::describe_keywords(self.captures, visit);
  }
};

struct InfoArguments {
  CaptureArguments captures;
  py::object progress = py::none();

  static void describe_keywords(auto&& self, auto&& visit) {
    CaptureArguments::describe_keywords(self.captures, visit);
    visit("progress", self.progress, progress_sentence);
  }
};

// Negative numbers count from the end, as everywhere in Python.
std::size_t frame_of(std::ptrdiff_t i, std::size_t frames) {
  const auto count = static_cast<std::ptrdiff_t>(frames);
  if (i < -count || i >= count)
    throw py::index_error(fmt::format("there is no frame {}; the capture has {} of this kind", i, frames));
  return static_cast<std::size_t>(i < 0 ? i + count : i);
}

py::array depth(const OpenCapture& self, std::ptrdiff_t i) {
  const std::size_t frame = frame_of(i, self.capture->depth_frames());
  return array_of(without_lock([&] { return self.capture->depth(frame); }));
}

py::array color(const OpenCapture& self, std::ptrdiff_t i) {
  const std::size_t frame = frame_of(i, self.capture->color_frames());
  return array_of(without_lock([&] { return self.capture->color(frame); }));
}

py::object color_of(const OpenCapture& self, std::ptrdiff_t i) {
  const std::size_t frame = frame_of(i, self.capture->depth_frames());
  return array_of(without_lock([&] { return self.capture->color_of(frame); }));
}

py::object infrared_of(const OpenCapture& self, std::ptrdiff_t i, const std::string& imager) {
  const std::size_t frame = frame_of(i, self.capture->depth_frames());
  if (imager != "left" && imager != "right")
    throw UsageError("imager", fmt::format("there is no {}", printable(imager)), "give 'left' or 'right'");
  const Imager chosen = imager == "left" ? Imager::left : Imager::right;
  return array_of(without_lock([&] { return self.capture->infrared_of(frame, chosen); }));
}

std::string text_of(const OpenCapture& self) {
  const CaptureInfo& info = self.capture->info();
  return fmt::format("<rva.Capture {}: {}, {} depth and {} colour images, {}x{}>", printable(self.path),
                     info.format, self.capture->depth_frames(), self.capture->color_frames(),
                     info.depth.width, info.depth.height);
}

std::shared_ptr<OpenCapture> open(py::handle path, const py::kwargs& given) {
  OpenArguments arguments;
  take("open", given, arguments);
  return std::const_pointer_cast<OpenCapture>(capture_from(path, arguments.captures));
}

py::object info(py::handle given_capture, const py::kwargs& given) {
  InfoArguments arguments;
  take("info", given, arguments);
  const auto opened = capture_from(given_capture, arguments.captures);
  const Progress progress = progress_to(arguments.progress);
  const std::string text = without_lock(
      [&] { return json_text(json_of(*opened->capture, summarize(*opened->capture, progress))); });
  return object_of(text);
}

}  // namespace

void add_captures(py::module_& module) {
  py::class_<OpenCapture, std::shared_ptr<OpenCapture>>(
      module, "Capture", "What one camera recorded from one position. rva.open() opens one.")
      .def_readonly("path", &OpenCapture::path, "The path as it was given.")
      .def_property_readonly(
          "format", [](const OpenCapture& self) { return self.capture->info().format; },
          "'rva-capture', 'open3d', 'tum', 'images', 'bag', 'db3' or 'mcap'.")
      .def_property_readonly(
          "depth_frames", [](const OpenCapture& self) { return self.capture->depth_frames(); },
          "Number of depth images.")
      .def_property_readonly(
          "color_frames", [](const OpenCapture& self) { return self.capture->color_frames(); },
          "Number of colour images, which may differ from that of depth images.")
      .def_property_readonly(
          "depth_unit_m", [](const OpenCapture& self) { return self.capture->info().depth_unit_m; },
          "Depth of one step of a depth image, metres.")
      .def_property_readonly(
          "intrinsics",
          [](const OpenCapture& self) {
            const Intrinsics& camera = self.capture->info().depth;
            return py::make_tuple(camera.fx, camera.fy, camera.cx, camera.cy);
          },
          "fx, fy, cx and cy of the depth images, px.")
      .def_property_readonly(
          "notes", [](const OpenCapture& self) { return self.capture->info().notes; },
          "Remarks on the files for the user.")
      .def("depth", depth, py::arg("i"),
           "depth(self, i)\n--\n\nDepth image i, height x width, in steps of depth_unit_m; 0 is no "
           "measurement.")
      .def("color", color, py::arg("i"),
           "color(self, i)\n--\n\nColour image i, height x width x 3: red, green, blue.")
      .def("color_of", color_of, py::arg("i"),
           "color_of(self, i)\n--\n\nThe colour image that was taken with depth image i; None where there "
           "is none.")
      .def("infrared_of", infrared_of, py::arg("i"), py::arg("imager") = "left",
           "infrared_of(self, i, imager='left')\n--\n\nAn imager's infrared image of depth image i under "
           "the projector, in 256ths of a grey level; None where there is none.")
      .def(
          "__len__", [](const OpenCapture& self) { return self.capture->depth_frames(); },
          "__len__(self)\n--\n\nNumber of depth images.")
      .def("__repr__", text_of, "__repr__(self)\n--\n\n");
  const auto opening = description<OpenArguments>(
      "open", "path", "Opens a capture of any format. Images are read when they are asked for.");
  module.def("open", open, py::arg("path"), opening.c_str());
  const auto informing = description<InfoArguments>(
      "info", "capture",
      "What a capture contains, as rva info --json prints it; all of it is read to "
      "check that it is sound. Takes a path or a Capture.");
  module.def("info", info, py::arg("capture"), informing.c_str());
}

}  // namespace rva::python
