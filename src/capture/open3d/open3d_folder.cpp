#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "capture/formats.hpp"
#include "capture/images/depth_file.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {

CaptureInfo parse_open3d_json(const std::string& text, const std::string& source) {
  const nlohmann::json json = parse_json(text, source);
  const JsonObject document(json, source);
  CaptureInfo info;
  info.format = "open3d";
  info.source_json = text;
  // Open3D stores the matrix column by column: fx 0 0, 0 fy 0, cx cy 1. ROS and many users write rows.
  std::vector<double> matrix = document.numbers("intrinsic_matrix", 9);
  const bool by_rows = matrix[6] == 0.0 && matrix[7] == 0.0 && matrix[2] != 0.0 && matrix[5] != 0.0;
  if (by_rows) {
    std::swap(matrix[2], matrix[6]);
    std::swap(matrix[5], matrix[7]);
    info.notes.emplace_back(
        "the intrinsic matrix is written row by row, although Open3D writes it column by column");
  }
  info.depth.width = document.integer("width");
  info.depth.height = document.integer("height");
  info.depth.fx = matrix[0];
  info.depth.fy = matrix[4];
  info.depth.cx = matrix[6];
  info.depth.cy = matrix[7];
  try {
    info.depth.check();
  } catch (const Error& error) {
    throw Error(document.name_of(error.source()), error.problem(), "correct the file");
  }
  const double units_per_m = document.optional_number("depth_scale").value_or(1000.0);
  if (!(units_per_m >= 1.0))
    throw Error(document.name_of("depth_scale"), "must be 1 or more", "correct the file");
  info.depth_unit_m = 1.0 / units_per_m;
  info.unit_is_assumed = !document.has("depth_scale");
  info.color = info.depth;
  info.color_from_depth = Transform::Identity();
  CameraInfo camera;
  camera.model = document.optional_string("device_name").value_or("");
  camera.serial = document.optional_string("serial_number").value_or("");
  if (!camera.model.empty() || !camera.serial.empty()) info.camera = camera;
  return info;
}

std::unique_ptr<Capture> open_open3d_folder(const fs::path& folder, const fs::path& intrinsic_file,
                                            const CaptureOptions& options) {
  CaptureInfo info = parse_open3d_json(read_text_file(intrinsic_file), printable(intrinsic_file));
  info.no_depth = options.no_depth;
  settle_unit(options, info);
  return std::make_unique<FolderCapture>(
      folder, std::move(info),
      FrameFiles{depth_files(folder / "depth"), image_files(folder / "color", {".png", ".jpg", ".jpeg"})});
}

}  // namespace rva
