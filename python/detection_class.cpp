#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "core/json_object.hpp"
#include "detect/result_folder.hpp"
#include "detection.hpp"
#include "images.hpp"
#include "long_call.hpp"
#include "module.hpp"
#include "python_json.hpp"

namespace rva::python {
namespace {

namespace py = pybind11;
using Result = std::shared_ptr<DetectionResult>;

// An attribute that is a member of Finding.
template <typename Member>
auto of_finding(Member Finding::*member) {
  return [member](const ResultFinding& self) { return self.finding().*member; };
}

py::object position_of(const ResultFinding& self) {
  const auto& position = self.finding().position_m;
  if (!position) return py::none();
  return py::make_tuple(position->x(), position->y(), position->z());
}

py::object size_of(const ResultFinding& self) {
  const auto& size = self.finding().size_mm;
  if (!size) return py::none();
  return py::make_tuple((*size)[0], (*size)[1]);
}

py::tuple evidence_of(const ResultFinding& self) {
  const Evidence& evidence = self.finding().evidence;
  if (evidence.depth && evidence.appearance) return py::make_tuple("depth", "appearance");
  if (evidence.appearance) return py::make_tuple("appearance");
  return evidence.depth ? py::make_tuple("depth") : py::tuple();
}

py::object name_of_class(const ResultFinding& self) {
  const FindingClass* const named = self.named();
  return named != nullptr ? py::object(py::str(named->name)) : py::none();
}

py::object probability_of(const ResultFinding& self) {
  const FindingClass* const named = self.named();
  return named != nullptr ? py::cast(named->probability) : py::none();
}

py::array pixels_of(const py::object& self) {
  require_numpy();
  const auto& pixels = self.cast<const ResultFinding&>().finding().pixels;
  return read_only<std::uint32_t>({pixels.size()}, pixels.data(), self);
}

py::tuple findings_of(const Result& self) {
  py::tuple findings(self->sides.detection.findings.findings.size());
  for (std::size_t i = 0; i < findings.size(); ++i) findings[i] = py::cast(ResultFinding{self, i});
  return findings;
}

// An image of the result, which keeps the result alive.
template <typename Image>
auto image_of(Image Detection::*member) {
  return [member](const py::object& self) {
    return view_of(self.cast<const DetectionResult&>().sides.detection.*member, self);
  };
}

py::object left_out_of(const py::object& self) {
  const Mask& mask = self.cast<const DetectionResult&>().sides.detection.left_out;
  return mask.empty() ? py::none() : py::object(view_of(mask, self));
}

py::object least_of(const py::object& self) {
  const auto& level = self.cast<const DetectionResult&>().sides.detection.level_of_detection;
  return level ? py::object(view_of(level->least_mm, self)) : py::none();
}

std::vector<std::string> save(const DetectionResult& self, const std::filesystem::path& folder,
                              bool overwrite) {
  return without_lock([&] {
    OutputFolder out(folder, result_files(), overwrite ? Existing::replace : Existing::refuse);
    auto warnings = write(self, out);
    out.commit();
    return warnings;
  });
}

void add_finding(py::module_& module) {
  py::class_<ResultFinding>(module, "Finding",
                            "One change. Quantities that a method does not provide are None.")
      .def_property_readonly("id", of_finding(&Finding::id), "From 1, the most suspicious first.")
      .def_property_readonly(
          "kind", [](const ResultFinding& self) { return std::string(name_of(self.finding().kind)); },
          "'added', 'removed' or 'appearance'.")
      .def_property_readonly(
          "box",
          [](const ResultFinding& self) {
            const Box& box = self.finding().box;
            return py::make_tuple(box.x, box.y, box.width, box.height);
          },
          "x, y, width and height in the final depth image, px.")
      .def_property_readonly(
          "area_px", [](const ResultFinding& self) { return self.finding().pixels.size(); },
          "Number of changed pixels.")
      .def_property_readonly("pixels", pixels_of,
                             "The changed pixels, as indices in row-major order; read-only.")
      .def_property_readonly(
          "centroid",
          [](const ResultFinding& self) {
            return py::make_tuple(self.finding().centroid.x(), self.finding().centroid.y());
          },
          "Mean of the pixels.")
      .def_property_readonly("position_m", position_of,
                             "x, y and z in the frame of the final depth camera, metres.")
      .def_property_readonly("size_mm", size_of, "The box's width and height at the depth of the finding.")
      .def_property_readonly("height_mm", of_finding(&Finding::height_mm),
                             "Median decrease of depth, along z: positive for added, negative for removed.")
      .def_property_readonly("above_surroundings_mm", of_finding(&Finding::above_surroundings_mm),
                             "Height above the surface around it, along z.")
      .def_property_readonly("top_above_surroundings_mm", of_finding(&Finding::top_above_surroundings_mm),
                             "Height of its top above the surface that it lies on, at right angles to it.")
      .def_property_readonly("top_is_least", of_finding(&Finding::top_is_least),
                             "Whether the top may be higher.")
      .def_property_readonly("background_jump", of_finding(&Finding::background_jump),
                             "Whether a farther surface was seen there before, or is seen now.")
      .def_property_readonly("score", of_finding(&Finding::score),
                             "Larger is more suspicious; comparable within a method.")
      .def_property_readonly("p_value", of_finding(&Finding::p_value),
                             "Probability that an inspection without a change shows something as rare.")
      .def_property_readonly("moved_from", of_finding(&Finding::moved_from),
                             "Of an added finding, the id of a removed one of about the same size.")
      .def_property_readonly("evidence", evidence_of, "'depth', 'appearance' or both.")
      .def_property_readonly("class_name", name_of_class,
                             "What it may be, or 'unknown'; None where no model was shown it.")
      .def_property_readonly("probability", probability_of,
                             "Of the most probable class, also where that is unknown.")
      .def("__repr__",
           [](const ResultFinding& self) { return fmt::format("<rva.Finding {}>", text_of(self)); })
      .def("__str__", [](const ResultFinding& self) { return text_of(self); });
}

}  // namespace

void add_detection(py::module_& module) {
  add_finding(module);
  py::class_<DetectionResult, Result>(
      module, "Detection", "What rva.detect() found. Images are in the view of the first final capture.")
      .def_property_readonly("findings", findings_of, "All findings, the most suspicious first.")
      .def_property_readonly(
          "method", [](const DetectionResult& self) { return self.sides.detection.findings.method; },
          "The method that compared the captures.")
      .def_property_readonly(
          "warnings", [](const DetectionResult& self) { return self.warnings; },
          "What limits the result; one line each.")
      .def_property_readonly("changed", image_of(&Detection::changed),
                             "Mask of every changed pixel: 255, else 0; read-only.")
      .def_property_readonly("initial_m", image_of(&Detection::initial_m),
                             "Depth before, metres; 0 where not measured; read-only.")
      .def_property_readonly("final_m", image_of(&Detection::final_m),
                             "Depth after, metres; 0 where not measured; read-only.")
      .def_property_readonly("left_out", left_out_of,
                             "Mask of the pixels left out as asked; None where there are none; read-only.")
      .def_property_readonly("least_mm", least_of,
                             "The least height that would have been found, mm; NaN where nothing could be "
                             "judged; None of methods that do not estimate it; read-only.")
      .def_property_readonly(
          "json", [](const DetectionResult& self) { return json_file_text(self.json); },
          "The text of detections.json.")
      .def(
          "as_dict", [](const DetectionResult& self) { return object_of(self.json); },
          "as_dict(self)\n--\n\nThe content of detections.json.")
      .def("save", save, py::arg("out"), py::kw_only(), py::arg("overwrite") = false,
           "save(self, out, *, overwrite=False)\n--\n\nWrites the folder that rva detect writes. Returns "
           "warnings on pictures that are missing or only approximate.")
      .def("__len__",
           [](const DetectionResult& self) { return self.sides.detection.findings.findings.size(); })
      .def("__iter__", [](const Result& self) { return py::iter(findings_of(self)); })
      .def("__repr__",
           [](const DetectionResult& self) {
             const Findings& findings = self.sides.detection.findings;
             return fmt::format("<rva.Detection: {} finding(s), method {}>", findings.findings.size(),
                                findings.method);
           })
      .def("__str__", [](const Result& self) { return text_of(self); });
}

}  // namespace rva::python
