// Built instead of realsense_camera.cpp if librealsense2 is not installed.
#include <fmt/format.h>

#include "camera/realsense/plugged_in.hpp"
#include "camera/realsense/realsense.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

Error without() {
  const std::vector<PluggedIn> there = plugged_in_realsense();
  return {there.empty() ? "realsense" : printable(there.front().product),
          "this rva was built without librealsense2",
          "install librealsense2-dev (see docs/cameras.md) and run script/build again"};
}

}  // namespace

bool has_realsense() { return false; }

std::vector<FoundCamera> realsense_cameras() { throw without(); }

std::unique_ptr<Camera> open_realsense(const std::string& /*serial*/, const RealSenseOptions& options) {
  check_options(options);
  throw without();
}

}  // namespace rva
