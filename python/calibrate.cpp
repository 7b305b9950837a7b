#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <vector>

#include "core/file.hpp"
#include "geometry/robot_geometry_file.hpp"
#include "keywords.hpp"
#include "long_call.hpp"
#include "map/calibration.hpp"
#include "map/calibration_views.hpp"
#include "module.hpp"
#include "python_json.hpp"

namespace rva::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

struct CalibrateArguments {
  std::optional<fs::path> geometry{};
  bool overwrite = false;
  CalibrationOptions options{};
  py::object progress = py::none();

  static void describe_keywords(auto&& self, auto&& visit) {
    visit("geometry", self.geometry, "the geometry as it was measured; None for a robot as it is built");
    visit("overwrite", self.overwrite, "replace out");
    visit_options(self.options, visit);
    visit("progress", self.progress, progress_sentence);
  }
};

nlohmann::ordered_json calibrate_robot(const std::vector<fs::path>& captures, const fs::path& out,
                                       const CalibrateArguments& arguments) {
  require_replaceable_geometry(out, arguments.overwrite);
  check_options(arguments.options);
  const PanTiltChain given = arguments.geometry ? load_robot_geometry(*arguments.geometry) : PanTiltChain{};
  const std::vector<MapView> views = load_calibration_views(captures, progress_to(arguments.progress));
  const Calibration calibration = rva::calibrate(views, given, arguments.options);
  if (!calibration.doubt.empty())
    throw Error("views", calibration.doubt,
                "take more of them, over the whole range of the joints, in front of structured surfaces");
  replace_file(out, json_file_text(json_of(calibration.chain), 2));
  return json_of(calibration, views);
}

py::object calibrate(const std::vector<fs::path>& captures, const fs::path& out, const py::kwargs& given) {
  CalibrateArguments arguments;
  take("calibrate", given, arguments);
  return object_of(without_lock([&] { return calibrate_robot(captures, out, arguments); }));
}

}  // namespace

void add_calibrate(py::module_& module) {
  const auto text = description<CalibrateArguments>(
      "calibrate", "captures, out",
      "Finds where the robot's joints and camera are, from views at known joint angles, as rva calibrate "
      "does: captures are the paths of views from one position; out is the file of the geometry. Returns "
      "what "
      "rva calibrate --json prints.");
  module.def("calibrate", calibrate, py::arg("captures"), py::arg("out"), text.c_str());
}

}  // namespace rva::python
