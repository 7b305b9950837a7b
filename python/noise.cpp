#include "camera/noise.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

#include "camera/noise_files.hpp"
#include "captures.hpp"
#include "core/output_folder.hpp"
#include "images.hpp"
#include "keywords.hpp"
#include "long_call.hpp"
#include "module.hpp"
#include "python_json.hpp"

namespace rva::python {
namespace {

namespace py = pybind11;

struct NoiseArguments {
  std::optional<std::filesystem::path> out{};
  bool overwrite = false;
  NoiseOptions noise{};
  CaptureArguments captures{};
  py::object progress = py::none();

  static void describe_keywords(auto&& self, auto&& visit) {
    visit("out", self.out, "folder for std.png, drift.png and noise.json; None for no folder");
    visit("overwrite", self.overwrite, "replace an earlier result in out");
    visit_options(self.noise, visit);
    CaptureArguments::describe_keywords(self.captures, visit);
    visit("progress", self.progress, progress_sentence);
  }
};

std::shared_ptr<Noise> measure(const OpenCapture& opened, const NoiseArguments& arguments) {
  check_options(arguments.noise);
  std::optional<OutputFolder> out;
  if (arguments.out)
    out.emplace(*arguments.out, noise_files(), arguments.overwrite ? Existing::replace : Existing::refuse);
  auto noise = std::make_shared<Noise>(
      measure_noise(*opened.capture, arguments.noise, progress_to(arguments.progress)));
  if (out) {
    write_noise(*noise, *out);
    out->commit();
  }
  return noise;
}

std::shared_ptr<Noise> noise(py::handle capture, const py::kwargs& given) {
  NoiseArguments arguments;
  take("noise", given, arguments);
  const auto opened = capture_from(capture, arguments.captures);
  return without_lock([&] { return measure(*opened, arguments); });
}

}  // namespace

void add_noise(py::module_& module) {
  py::class_<Noise, std::shared_ptr<Noise>>(module, "Noise", "What rva.noise() measured.")
      .def_property_readonly(
          "std_mm", [](const py::object& self) { return view_of(self.cast<const Noise&>().std_mm, self); },
          "Standard deviation along z of each pixel, mm; NaN where it was measured less than twice; "
          "read-only.")
      .def_property_readonly(
          "welch_p", [](const py::object& self) { return view_of(self.cast<const Noise&>().welch_p, self); },
          "p-value of Welch's test of each pixel, first against last frames; NaN where untested; read-only.")
      .def(
          "as_dict", [](const Noise& self) { return object_of(json_of(self.report)); },
          "as_dict(self)\n--\n\nThe content of noise.json.")
      .def("__repr__", [](const Noise& self) {
        return fmt::format("<rva.Noise: median {:.2f} mm, {} frames>", self.report.overall.median_std_mm,
                           self.report.frames);
      });
  const auto text = description<NoiseArguments>(
      "noise", "capture",
      "Measures how much the depth of a still scene varies, as rva noise does. Takes a path or a Capture.");
  module.def("noise", noise, py::arg("capture"), text.c_str());
}

}  // namespace rva::python
