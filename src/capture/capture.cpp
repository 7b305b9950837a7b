#include "capture/capture.hpp"

#include <fmt/format.h>

#include <array>
#include <system_error>
#include <vector>

#include "capture/file_kind.hpp"
#include "capture/formats.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {

std::optional<ColorImage> Capture::color_of(std::size_t depth_frame) const {
  return depth_frame < color_frames() ? std::optional(color(depth_frame)) : std::nullopt;
}

std::optional<FineGrayImage> Capture::infrared_of(std::size_t /*depth_frame*/, Imager /*imager*/) const {
  return std::nullopt;
}

bool Capture::has_infrared(Imager /*imager*/, Light /*light*/) const { return false; }

// The mean is taken over the images of the frames; a capture that stores the mean itself overrides this.
std::optional<Image<float>> Capture::infrared_mean(Imager imager, Light light) const {
  if (!has_infrared(imager, light) || light != Light::projector) return std::nullopt;
  Image<float> mean(info().depth.width, info().depth.height);
  int images = 0;
  for (std::size_t frame = 0; frame < depth_frames(); ++frame) {
    const std::optional<FineGrayImage> image = infrared_of(frame, imager);
    if (!image) continue;
    ++images;
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += static_cast<float>((*image)[i]);
  }
  if (images == 0) return std::nullopt;
  for (float& value : mean.pixels()) value /= static_cast<float>(images * fine_steps_per_grey_level);
  return mean;
}

FrameMetadata Capture::metadata_of(std::size_t /*depth_frame*/) const { return {}; }

std::map<Imager, FineGrayImage> infrared_of(const Capture& capture, std::size_t depth_frame) {
  std::map<Imager, FineGrayImage> images;
  for (const Imager imager : both_imagers) {
    if (auto image = capture.infrared_of(depth_frame, imager)) images.emplace(imager, std::move(*image));
  }
  return images;
}

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

namespace {

// Open3D's recorders, its tutorials and StrayVisualizer each use another name.
constexpr std::array open3d_descriptions{"intrinsic.json", "camera_intrinsic.json", "camera_intrinsics.json"};

// rosbag2 puts a recording into a folder, and so do many users.
std::unique_ptr<Capture> open_recording_in(const fs::path& folder, const std::vector<fs::path>& recordings,
                                           const CaptureOptions& options) {
  if (recordings.size() > 1)
    throw Error(printable(folder),
                fmt::format("contains {} recordings, such as {}", recordings.size(),
                            printable(recordings.front().filename())),
                "give one of them");
  require_recording(recordings.front());
  return open_recording(recordings.front(), options);
}

std::unique_ptr<Capture> open_folder(const fs::path& folder, const CaptureOptions& options) {
  std::error_code ignored;
  const auto holds = [&](const char* name) { return fs::exists(folder / name, ignored); };
  if (holds("capture.json")) return open_capture_folder(folder, options);
  for (const char* name : open3d_descriptions) {
    if (holds(name)) return open_open3d_folder(folder, folder / name, options);
  }
  if (holds("depth.txt") || association_list(folder)) return open_tum_folder(folder, options);
  const std::vector<fs::path> recordings = image_files(folder, {".db3", ".mcap", ".bag"});
  if (!recordings.empty()) return open_recording_in(folder, recordings, options);
  if (!bare_depth_files(folder).empty()) return open_bare_folder(folder, options);
  throw Error(printable(folder),
              "contains no capture.json, no intrinsic.json of Open3D, no depth.txt or associations.txt of "
              "TUM, no recording and no "
              "depth image",
              "give the folder of a capture");
}

}  // namespace

std::unique_ptr<Capture> open_capture(const fs::path& path, const CaptureOptions& options) {
  require_utf8(path);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw Error(printable(path), "no such capture", "check the path");
  if (fs::is_directory(path, ignored)) return open_folder(path, options);
  require_recording(path);
  return open_recording(path, options);
}

// Equation 1 of docs/math.md.
StereoScale stereo_scale(const CaptureInfo& info) {
  constexpr double usual_baseline_m = 0.050;
  const double baseline_m = info.camera && info.camera->baseline_m.value_or(0.0) > 0.0
                                ? *info.camera->baseline_m
                                : usual_baseline_m;
  return {.focal_baseline_m_px = info.depth.fx * baseline_m, .unit_m = info.depth_unit_m};
}

}  // namespace rva
