#include "depth/capture.hpp"

#include <system_error>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "depth/formats.hpp"

namespace fs = std::filesystem;

namespace rva {

std::unique_ptr<Capture> open_capture(const fs::path& path, const CaptureOptions& options) {
  require_utf8(path);
  std::error_code ignored;
  const auto holds = [&](const char* name) { return fs::exists(path / name, ignored); };
  if (!fs::exists(path, ignored)) throw Error(printable(path), "no such capture", "check the path");
  if (!fs::is_directory(path, ignored))
    throw Error(printable(path), "a file, and captures are folders as yet", "give the folder of a capture");
  if (holds("capture.json")) return open_capture_folder(path);
  if (holds("intrinsic.json")) return open_open3d_folder(path, path / "intrinsic.json");
  if (holds("camera_intrinsic.json")) return open_open3d_folder(path, path / "camera_intrinsic.json");
  if (holds("depth.txt")) return open_tum_folder(path, options);
  throw Error(printable(path), "no capture.json, no intrinsic.json of Open3D and no depth.txt of TUM in it",
              "give the folder of a capture");
}

}  // namespace rva
