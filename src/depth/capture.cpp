#include "depth/capture.hpp"

#include <system_error>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "depth/formats.hpp"

namespace fs = std::filesystem;

namespace rva {

std::optional<ColorImage> Capture::color_of(std::size_t depth_frame) const {
  return depth_frame < color_frames() ? std::optional(color(depth_frame)) : std::nullopt;
}

std::optional<GrayImage> Capture::infrared_of(std::size_t /*depth_frame*/) const { return std::nullopt; }

std::optional<Image<float>> Capture::infrared_mean() const { return std::nullopt; }

FrameMetadata Capture::metadata_of(std::size_t /*depth_frame*/) const { return {}; }

std::size_t lost_frames(const Capture& capture) {
  std::size_t lost = 0;
  std::optional<std::uint64_t> before;
  for (std::size_t i = 0; i < capture.depth_frames(); ++i) {
    const std::optional<std::uint64_t> counter = capture.metadata_of(i).counter;
    if (before && counter && *counter > *before + 1) lost += *counter - *before - 1;
    before = counter;
  }
  return lost;
}

std::unique_ptr<Capture> open_capture(const fs::path& path, const CaptureOptions& options) {
  require_utf8(path);
  std::error_code ignored;
  const auto holds = [&](const char* name) { return fs::exists(path / name, ignored); };
  if (!fs::exists(path, ignored)) throw Error(printable(path), "no such capture", "check the path");
  if (!fs::is_directory(path, ignored)) return open_recording(path, options);
  if (holds("capture.json")) return open_capture_folder(path, options);
  if (holds("intrinsic.json")) return open_open3d_folder(path, path / "intrinsic.json", options);
  if (holds("camera_intrinsic.json"))
    return open_open3d_folder(path, path / "camera_intrinsic.json", options);
  if (holds("depth.txt")) return open_tum_folder(path, options);
  throw Error(printable(path), "no capture.json, no intrinsic.json of Open3D and no depth.txt of TUM in it",
              "give the folder of a capture");
}

}  // namespace rva
