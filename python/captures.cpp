#include "captures.hpp"

#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include <utility>

#include "capture/capture_view.hpp"
#include "capture/stated_camera.hpp"
#include "core/error.hpp"
#include "core/options.hpp"
#include "core/units.hpp"
#include "long_call.hpp"

namespace rva::python {
namespace {

namespace py = pybind11;

void require_none_given(const CaptureArguments& arguments) {
  if (arguments.intrinsics || !arguments.no_depth.empty() || arguments.depth_unit_mm || arguments.topic)
    throw UsageError("captures",
                     "they are open, so intrinsics, no_depth, depth_unit and topic have no effect",
                     "give these to rva.open()");
}

}  // namespace

CaptureOptions CaptureArguments::options() const {
  CaptureOptions options;
  options.no_depth = no_depth;
  options.topic = topic;
  if (intrinsics) options.intrinsics = stated_intrinsics(*intrinsics);
  if (!depth_unit_mm) return options;
  if (!(*depth_unit_mm >= least_depth_unit_mm && *depth_unit_mm <= most_depth_unit_mm))
    throw OptionError("depth-unit", fmt::format("{} is out of range", *depth_unit_mm),
                      fmt::format("give {} to {} mm", least_depth_unit_mm, most_depth_unit_mm));
  options.depth_unit_m = m_per_mm * *depth_unit_mm;
  return options;
}

Captures CaptureSide::captures() const {
  Captures captures;
  for (const auto& owner : owners)
    captures.push_back(std::make_unique<CaptureView>(*owner->capture, owner->capture->info()));
  return captures;
}

std::vector<std::filesystem::path> CaptureSide::paths() const {
  std::vector<std::filesystem::path> paths;
  for (const auto& owner : owners) paths.push_back(owner->path);
  return paths;
}

std::shared_ptr<const OpenCapture> capture_from(py::handle object, const CaptureArguments& arguments) {
  if (py::isinstance<OpenCapture>(object)) {
    require_none_given(arguments);
    return object.cast<std::shared_ptr<OpenCapture>>();
  }
  std::filesystem::path path;
  try {
    path = object.cast<std::filesystem::path>();
  } catch (const py::cast_error&) {
    throw py::type_error(
        fmt::format("{} is neither a path nor an rva.Capture", std::string(py::repr(object))));
  }
  const CaptureOptions options = arguments.options();
  return without_lock([&] {
    auto capture = open_capture(path, options);
    return std::make_shared<OpenCapture>(OpenCapture{std::move(path), std::move(capture)});
  });
}

CaptureSide side_from(py::handle object, const CaptureArguments& arguments, const char* side) {
  CaptureSide taken;
  if (!py::isinstance<py::list>(object) && !py::isinstance<py::tuple>(object)) {
    taken.owners.push_back(capture_from(object, arguments));
    return taken;
  }
  for (const py::handle one : object) taken.owners.push_back(capture_from(one, arguments));
  if (taken.owners.empty())
    throw UsageError("captures", fmt::format("there is none of {} the work", side), "give at least one");
  return taken;
}

}  // namespace rva::python
