#include "capture/open3d/open3d_writer.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <system_error>

#include "capture/align.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/interrupt.hpp"
#include "core/json_object.hpp"
#include "depth/image_file.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

nlohmann::ordered_json json_of(const Intrinsics& color, double depth_unit_m, const CameraInfo& camera) {
  return {
      {"width", color.width},
      {"height", color.height},
      {"intrinsic_matrix", {color.fx, 0.0, 0.0, 0.0, color.fy, 0.0, color.cx, color.cy, 1.0}},  // by columns
      {"depth_scale", 1.0 / depth_unit_m},
      {"device_name", camera.model},
      {"serial_number", camera.serial}};
}

void require_straight_color(const CaptureInfo& info) {
  if (!info.color)
    throw Error("capture", "has no colour camera to align depth to",
                "export it as a point cloud (ply or pcd)");
  if (!info.color_from_depth)
    throw Error("capture", "does not state the extrinsics of its colour camera (color_from_depth)",
                "export it as a point cloud (ply or pcd)");
  if (info.color->distortion != Distortion::none)
    throw Error("capture", "its colour images have lens distortion, which an Open3D folder cannot describe",
                "export it as a point cloud (ply or pcd)");
}

}  // namespace

std::vector<std::string> open3d_files() {
  return {"intrinsic.json", "depth/[0-9][0-9][0-9][0-9][0-9].png", "color/[0-9][0-9][0-9][0-9][0-9].jpg"};
}

void write_open3d_folder(const Capture& capture, const fs::path& folder, const Progress& progress) {
  constexpr int quality = 95;
  const CaptureInfo& info = capture.info();
  require_straight_color(info);
  if (capture.color_frames() == 0)
    throw Error("capture", "contains no colour image", "export it as a point cloud (ply or pcd)");
  std::error_code ignored;  // if a folder is missing, write_file() fails and reports why
  fs::create_directory(folder / "depth", ignored);
  fs::create_directory(folder / "color", ignored);
  write_file(folder / "intrinsic.json",
             json_file_text(json_of(*info.color, info.depth_unit_m, info.camera.value_or(CameraInfo{}))));
  ColorImage last = capture.color(0);
  for (std::size_t i = 0; i < capture.depth_frames(); ++i) {
    throw_if_interrupted();
    if (std::optional<ColorImage> color = capture.color_of(i)) last = std::move(*color);
    write_file(folder / "depth" / fmt::format("{:05}.png", i),
               encode_png(align_to_color(capture.depth(i), info)));
    write_file(folder / "color" / fmt::format("{:05}.jpg", i), encode_jpeg(last, quality));
    if (progress) progress("exporting", i + 1, capture.depth_frames());
  }
}

}  // namespace rva
