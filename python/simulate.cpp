#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <memory>

#include "captures.hpp"
#include "core/output_folder.hpp"
#include "keywords.hpp"
#include "long_call.hpp"
#include "module.hpp"
#include "scene/file/scene_file.hpp"
#include "sim/sensor/camera_models.hpp"
#include "sim/simulated_capture.hpp"

namespace rva::python {
namespace {

namespace py = pybind11;

struct SimulateArguments {
  bool overwrite = false;
  SimulatedCaptureOptions content{};
  std::uint64_t seed = default_seed;
  std::optional<std::string> debris{};
  std::optional<std::uint64_t> debris_seed{};
  std::optional<std::array<double, 3>> position_m{};
  std::optional<double> pan_deg{};
  std::optional<double> tilt_deg{};
  std::string camera_model = SimulationOrigin{}.camera_model;
  bool all_colors = false;
  StereoSensorOptions sensor{};
  py::object progress = py::none();

  static void describe_keywords(auto&& self, auto&& visit) {
    visit("overwrite", self.overwrite, "replace an earlier capture in out");
    visit("frames", self.content.frames, "depth frames");
    visit("seed", self.seed, "of all noise; the same seed gives the same bytes");
    visit("debris", self.debris,
          "'none': the bay as it was before the work; or a scene file whose debris is used instead");
    visit("debris_seed", self.debris_seed, "seed of debris that the scene places at random");
    visit("position", self.position_m, "x, y and z of the robot's foot in m");
    visit("pan", self.pan_deg, "first joint in degrees, positive to the left");
    visit("tilt", self.tilt_deg, "second joint in degrees, positive up");
    visit("camera_model", self.camera_model,
          "with another matcher: d435, census-5, census-13, semi-global, correlation-5, correlation-9, or "
          "random:SEED or imperfect:SEED, drawn at random");
    visit("all_colors", self.all_colors, "a colour image with every frame, not the first only");
    visit("infrared", self.content.infrared,
          "also write what both infrared imagers saw in the last frame, 10 bits");
    visit("lamp", self.content.lamp,
          "also infrared images of as many frames with the projector off and the lamp on");
    visit_options(self.sensor, visit);
    visit("progress", self.progress, progress_sentence);
  }
};

// The options of the camera model, except those that were given.
StereoSensorOptions sensor_of(const SimulateArguments& arguments, const py::kwargs& given) {
  SimulateArguments of_model;
  of_model.sensor = camera_model(arguments.camera_model);
  take("simulate", given, of_model);
  return of_model.sensor;
}

SceneOverrides overrides_of(const SimulateArguments& arguments) {
  SceneOverrides overrides;
  overrides.no_debris = arguments.debris == "none";
  if (arguments.debris && !overrides.no_debris) overrides.debris_file = *arguments.debris;
  overrides.debris_seed = arguments.debris_seed;
  if (const auto& at = arguments.position_m)
    overrides.position_m = Eigen::Vector3d((*at)[0], (*at)[1], (*at)[2]);
  overrides.pan_deg = arguments.pan_deg;
  overrides.tilt_deg = arguments.tilt_deg;
  return overrides;
}

void write(const SimulateArguments& arguments, const std::filesystem::path& scene,
           const std::filesystem::path& folder) {
  OutputFolder out(folder, simulated_capture_files(),
                   arguments.overwrite ? Existing::replace : Existing::refuse);
  SimulatedCamera camera(load_scene(scene, overrides_of(arguments)), arguments.sensor, arguments.seed,
                         arguments.all_colors ? ColorFrames::all : ColorFrames::first);
  if (arguments.content.lamp && !camera.has_lamp())
    throw OptionError("lamp", "there is none with lamp_light=0", "leave one of them out");
  const SimulationOrigin origin{.camera_model = arguments.camera_model,
                                .debris = arguments.debris.value_or(""),
                                .debris_seed = arguments.debris_seed};
  write_simulated_capture(camera, origin, arguments.content, out, progress_to(arguments.progress));
  out.commit();
}

std::shared_ptr<OpenCapture> simulate(const std::filesystem::path& scene, const std::filesystem::path& out,
                                      const py::kwargs& given) {
  SimulateArguments arguments;
  take("simulate", given, arguments);
  check_options(arguments.sensor);
  arguments.sensor = sensor_of(arguments, given);
  return without_lock([&] {
    write(arguments, scene, out);
    return std::make_shared<OpenCapture>(OpenCapture{out, open_capture(out)});
  });
}

}  // namespace

void add_simulate(py::module_& module) {
  const auto text = description<SimulateArguments>(
      "simulate", "scene, out",
      "Renders a capture of a scene, with its truth, as rva simulate does, and opens it.");
  module.def("simulate", simulate, py::arg("scene"), py::arg("out"), text.c_str());
}

}  // namespace rva::python
